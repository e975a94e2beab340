// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FLAT_MESH_BUILDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FLAT_MESH_BUILDER_H

#include <CGAL/Region_segmentation/internal/Area_vector_sum.h>
#include <CGAL/Region_segmentation/internal/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Fills the arrays of a `Flat_mesh`: faces and dual edges, each of them in any order, but an edge after its
/// two faces.
class Flat_mesh_builder
{
  using Index = Flat_mesh::Index;

public:
  struct Edge
  {
    Index lower, higher;
    Vector_3 d; // along the halfedge of the lower face
    bool is_constrained;
  };

  Flat_mesh_builder(std::size_t number_of_faces, std::size_t maximum_number_of_edges)
    : m_closed_edges(number_of_blocks(number_of_faces))
  {
    m_flat.m_normals.resize(number_of_faces);
    m_flat.m_areas.resize(number_of_faces);
    m_flat.m_lower_faces.resize(maximum_number_of_edges);
    m_flat.m_higher_faces.resize(maximum_number_of_edges);
    m_flat.m_lengths.resize(maximum_number_of_edges);
    m_flat.m_flags.resize(maximum_number_of_edges);
  }

  std::size_t maximum_number_of_edges() const { return m_flat.m_higher_faces.size(); }

  void set_face(std::size_t face, const Area_vector_sum& sum)
  {
    const Vector_3 area_vector = sum.area_vector();
    const double area = norm(area_vector);
    const bool is_finite = std::isfinite(area);
    const bool is_degenerate = !is_finite || !(area > 1e-12 * sum.squared_longest_edge());
    m_flat.m_normals[face] = is_degenerate ? Vector_3{} : (1 / area) * area_vector;
    m_flat.m_areas[face] = is_finite ? area : 0;
  }

  void set_edge(std::size_t edge, const Edge& e)
  {
    const Vector_3 &n = m_flat.normal(e.lower), &m = m_flat.normal(e.higher);
    const double cosine = dot(n, m), sign = dot(cross(n, m), e.d);
    const bool is_convex = sign > 0, is_concave = sign < 0;
    int flags = is_convex * Flat_mesh::CONVEX + is_concave * Flat_mesh::CONCAVE +
                e.is_constrained * Flat_mesh::CONSTRAINED +
                (cosine > Flat_mesh::nearly_flat) * Flat_mesh::NEARLY_FLAT +
                (cosine < Flat_mesh::not_flat) * Flat_mesh::NOT_FLAT;
    // The normal of a degenerate face is zero, and then the edge has no sign.
    if (!is_convex && !is_concave && (m_flat.is_degenerate(e.lower) || m_flat.is_degenerate(e.higher))) {
      flags |= Flat_mesh::CLOSED;
      m_closed_edges[e.lower / block_size].push_back(Index(edge));
    }
    m_flat.m_lower_faces[edge] = e.lower;
    m_flat.m_higher_faces[edge] = e.higher;
    m_flat.m_lengths[edge] = norm(e.d);
    m_flat.m_flags[edge] = std::uint8_t(flags);
  }

  /// \name Points
  /// With `Content::ANGLES_AND_POINTS` alone.
  /// @{
  void resize_points(std::size_t number_of_points) { m_flat.m_points.resize(number_of_points); }
  void set_point(std::size_t vertex, const Vector_3& point) { m_flat.m_points[vertex] = point; }

  /// Adds the corners of the next face.
  template <typename VertexOf>
  void add_corners(std::size_t number_of_corners, const VertexOf& vertex_of)
  {
    if (m_flat.m_first_corners.empty())
      m_flat.m_first_corners.push_back(0);
    for (std::size_t i = 0; i < number_of_corners; ++i)
      m_flat.m_corners.push_back(Index(vertex_of(i)));
    m_flat.m_first_corners.push_back(Index(m_flat.m_corners.size()));
  }
  /// @}

  /// `first_edge`: the place of the first edge; before it is nothing.
  Flat_mesh finish(std::size_t first_edge)
  {
    join_degenerate_faces();
    remove_edges_before(first_edge);
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
    for (const auto& block : m_closed_edges)
      for (Index edge : block) {
        if (m_flat.has_flag(edge, Flat_mesh::CONSTRAINED))
          continue;
        const Index lower = m_flat.lower_face(edge), higher = m_flat.higher_face(edge);
        if (m_flat.is_degenerate(lower))
          ways.push_back({lower, higher, edge});
        if (m_flat.is_degenerate(higher))
          ways.push_back({higher, lower, edge});
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

  void remove_edges_before(std::size_t first_edge)
  {
    if (first_edge == 0)
      return;
    const auto erase = [first_edge](auto& array) { array.erase(array.begin(), array.begin() + first_edge); };
    erase(m_flat.m_lower_faces);
    erase(m_flat.m_higher_faces);
    erase(m_flat.m_lengths);
    erase(m_flat.m_flags);
  }

  Flat_mesh m_flat;
  std::vector<std::vector<Index>> m_closed_edges; // by the block of their lower face
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FLAT_MESH_BUILDER_H
