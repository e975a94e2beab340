// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FLAT_MESH_BUILDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FLAT_MESH_BUILDER_H

#include <CGAL/Region_segmentation/internal/Flat_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Makes a `Flat_mesh` from faces in order, and from the dual edges of each to lower faces.
class Flat_mesh_builder
{
  using Index = Flat_mesh::Index;

public:
  Flat_mesh_builder(std::size_t number_of_faces, std::size_t maximum_number_of_edges)
  {
    m_flat.m_normals.reserve(number_of_faces);
    m_flat.m_areas.reserve(number_of_faces);
    m_flat.m_first_edges.reserve(number_of_faces + 1);
    m_flat.m_higher_faces.resize(maximum_number_of_edges);
    m_flat.m_lengths.resize(maximum_number_of_edges);
    m_flat.m_flags.resize(maximum_number_of_edges);
  }

  /// Adds the next face. Its area vector is Newell's formula relative to the first vertex,
  /// A = 1/2 sum (p_i - p_0) x (p_i+1 - p_0): there is no cancellation far from the origin.
  void add_face(const std::vector<Vector_3>& polygon, std::size_t number_of_higher_neighbors)
  {
    Vector_3 twice_area, to_previous;
    double longest = squared_norm(polygon.front() - polygon.back());
    for (std::size_t i = 1; i < polygon.size(); ++i) {
      const Vector_3 to_current = polygon[i] - polygon[0];
      twice_area = twice_area + cross(to_previous, to_current);
      longest = (std::max)(longest, squared_norm(polygon[i] - polygon[i - 1]));
      to_previous = to_current;
    }
    const Vector_3 area_vector = 0.5 * twice_area;
    const double area = norm(area_vector);
    const bool is_degenerate = !(area > 1e-12 * longest) || !std::isfinite(area);
    m_flat.m_normals.push_back(is_degenerate ? Vector_3{} : (1 / area) * area_vector);
    m_flat.m_areas.push_back(std::isfinite(area) ? area : 0);
    m_flat.m_first_edges.push_back(m_number_of_edges);
    m_number_of_edges += Index(number_of_higher_neighbors);
  }

  /// Adds an edge between the last face, `higher`, and a lower one; `d` runs along the halfedge of the
  /// lower one. While faces are read, `m_first_edges` holds the next free place of each.
  void add_edge(std::size_t lower, std::size_t higher, const Vector_3& d, bool is_constrained)
  {
    const Index edge = m_flat.m_first_edges[lower]++;
    std::uint8_t flags = is_constrained ? Flat_mesh::CONSTRAINED : 0;
    if (m_flat.is_degenerate(lower) || m_flat.is_degenerate(higher)) {
      flags |= Flat_mesh::CLOSED;
      m_degenerate_edges.push_back({Index(lower), edge});
    } else {
      const double sign = dot(cross(m_flat.normal(lower), m_flat.normal(higher)), d);
      flags |= sign > 0 ? Flat_mesh::CONVEX : sign < 0 ? Flat_mesh::CONCAVE : 0;
    }
    m_flat.m_higher_faces[edge] = Index(higher);
    m_flat.m_lengths[edge] = norm(d);
    m_flat.m_flags[edge] = flags;
  }

  void add_point(const Vector_3& point) { m_flat.m_points.push_back(point); }

  /// Adds the corners of the last face.
  template <typename VertexOf>
  void add_corners(std::size_t number_of_corners, const VertexOf& vertex_of)
  {
    if (m_flat.m_first_corners.empty())
      m_flat.m_first_corners.push_back(0);
    for (std::size_t i = 0; i < number_of_corners; ++i)
      m_flat.m_corners.push_back(Index(vertex_of(i)));
    m_flat.m_first_corners.push_back(Index(m_flat.m_corners.size()));
  }

  Flat_mesh finish()
  {
    m_flat.m_higher_faces.resize(m_number_of_edges);
    m_flat.m_lengths.resize(m_number_of_edges);
    m_flat.m_flags.resize(m_number_of_edges);
    // By now the place of each face is where the next one starts.
    m_flat.m_first_edges.insert(m_flat.m_first_edges.begin(), 0);
    join_degenerate_faces();
    return std::move(m_flat);
  }

private:
  /// Each degenerate face joins across its longest dual edge that is not constrained; of several, the
  /// one to the lower face, and of several to that face the first.
  void join_degenerate_faces()
  {
    struct Way
    {
      Index face, other, edge;
    };
    std::vector<Way> ways;
    for (const Degenerate_edge& e : m_degenerate_edges) {
      if (m_flat.has_flag(e.edge, Flat_mesh::CONSTRAINED))
        continue;
      const Index higher = m_flat.higher_face(e.edge);
      if (m_flat.is_degenerate(e.lower))
        ways.push_back({e.lower, higher, e.edge});
      if (m_flat.is_degenerate(higher))
        ways.push_back({higher, e.lower, e.edge});
    }
    std::sort(ways.begin(), ways.end(), [this](const Way& a, const Way& b) {
      const double a_length = m_flat.length(a.edge), b_length = m_flat.length(b.edge);
      if (a.face != b.face)
        return a.face < b.face;
      if (a_length != b_length)
        return a_length > b_length;
      return a.other != b.other ? a.other < b.other : a.edge < b.edge;
    });
    for (std::size_t i = 0; i < ways.size(); ++i)
      if (i == 0 || ways[i].face != ways[i - 1].face) {
        std::uint8_t& flags = m_flat.m_flags[ways[i].edge];
        flags = std::uint8_t((flags & ~Flat_mesh::CLOSED) | Flat_mesh::JOINING);
      }
  }

  struct Degenerate_edge
  {
    Index lower, edge;
  };

  Flat_mesh m_flat;
  Index m_number_of_edges = 0;
  std::vector<Degenerate_edge> m_degenerate_edges;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FLAT_MESH_BUILDER_H
