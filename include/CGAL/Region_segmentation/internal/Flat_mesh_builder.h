// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FLAT_MESH_BUILDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FLAT_MESH_BUILDER_H

#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/Mesh_walk.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// Reads a face graph, once, into a `Flat_mesh`.
class Flat_mesh_builder
{
  using Vector_3 = internal::Vector_3;
  using Index = Flat_mesh::Index;

public:
  /// \throws Invalid_input if a point is not finite
  template <typename FaceGraph, typename Pack>
  static Flat_mesh build(const internal::Mesh_walk<FaceGraph, Pack>& walk, const Pack& np)
  {
    Flat_mesh_builder builder;
    builder.read_points(walk, np);
    builder.read_faces(walk);
    builder.read_edges(walk, np);
    builder.join_degenerate_faces();
    return std::move(builder.m_flat);
  }

private:
  template <typename FaceGraph, typename Pack>
  void read_points(const internal::Mesh_walk<FaceGraph, Pack>& walk, const Pack& np)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                            get_const_property_map(vertex_point, walk.mesh()));
    m_points.reserve(walk.number_of_vertices());
    for (auto v : vertices(walk.mesh())) {
      const auto& p = get(point_map, v);
      const Vector_3 q{CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
      if (!is_finite(q))
        throw Invalid_input("the point of vertex " + std::to_string(m_points.size()) +
                            " is not finite");
      m_points.push_back(q);
    }
  }

  template <typename FaceGraph, typename Pack>
  void read_faces(const internal::Mesh_walk<FaceGraph, Pack>& walk)
  {
    m_flat.m_normals.reserve(walk.number_of_faces());
    m_flat.m_areas.reserve(walk.number_of_faces());
    std::vector<typename internal::Mesh_walk<FaceGraph, Pack>::halfedge_descriptor> around;
    std::vector<Vector_3> polygon;
    for (auto f : faces(walk.mesh())) {
      walk.boundary(f, around);
      polygon.clear();
      for (auto h : around)
        polygon.push_back(m_points[walk.source_rank(h)]);
      add_face(polygon);
    }
  }

  /// Newell's formula relative to the first vertex, A = 1/2 sum (p_i - p_0) x (p_i+1 - p_0): there is
  /// no cancellation far from the origin.
  void add_face(const std::vector<Vector_3>& polygon)
  {
    Vector_3 twice_area;
    double longest = norm(polygon.front() - polygon.back());
    Vector_3 to_previous;
    for (std::size_t i = 1; i < polygon.size(); ++i) {
      const Vector_3 to_current = polygon[i] - polygon[0];
      twice_area = twice_area + cross(to_previous, to_current);
      longest = (std::max)(longest, norm(polygon[i] - polygon[i - 1]));
      to_previous = to_current;
    }
    const Vector_3 area_vector = 0.5 * twice_area;
    const double area = norm(area_vector);
    const bool is_area_finite = std::isfinite(area);
    const bool is_degenerate = !is_area_finite || !(area > 1e-12 * longest * longest);
    m_flat.m_normals.push_back(is_degenerate ? Vector_3{} : unit(area_vector, area));
    m_flat.m_areas.push_back(is_area_finite ? area : 0);
  }

  static Vector_3 unit(const Vector_3& v, double length)
  {
    return {v.x / length, v.y / length, v.z / length};
  }

  template <typename FaceGraph, typename Pack>
  void read_edges(const internal::Mesh_walk<FaceGraph, Pack>& walk, const Pack& np)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    using Walk = internal::Mesh_walk<FaceGraph, Pack>;
    using edge_descriptor = typename boost::graph_traits<FaceGraph>::edge_descriptor;
    const FaceGraph& mesh = walk.mesh();
    const auto is_constrained =
      choose_parameter(get_parameter(np, CGAL::internal_np::edge_is_constrained),
                       Static_boolean_property_map<edge_descriptor, false>());

    m_flat.m_first_edges.reserve(walk.number_of_faces() + 1);
    const std::size_t number_of_edges = num_halfedges(mesh) / 2;
    m_flat.m_higher_faces.reserve(number_of_edges);
    m_flat.m_lengths.reserve(number_of_edges);
    m_flat.m_flags.reserve(number_of_edges);
    m_flat.m_first_edges.push_back(0);

    std::vector<typename Walk::halfedge_descriptor> around;
    std::vector<typename Walk::Neighbor> neighbors;
    std::size_t rank = 0;
    for (auto f : faces(mesh)) {
      walk.boundary(f, around);
      walk.higher_neighbors(rank, around, neighbors);
      for (const auto& n : neighbors) {
        const Vector_3 d = m_points[walk.source_rank(opposite(n.halfedge, mesh))] -
                           m_points[walk.source_rank(n.halfedge)];
        add_edge(rank, n.face, d, get(is_constrained, edge(n.halfedge, mesh)));
      }
      m_flat.m_first_edges.push_back(Index(m_flat.m_higher_faces.size()));
      ++rank;
    }
  }

  void add_edge(std::size_t lower, Index higher, const Vector_3& d, bool is_constrained)
  {
    std::uint8_t flags = is_constrained ? Flat_mesh::CONSTRAINED : 0;
    if (m_flat.is_degenerate(lower) || m_flat.is_degenerate(higher)) {
      flags |= Flat_mesh::CLOSED;
      m_degenerate_edges.push_back({Index(lower), Index(m_flat.m_higher_faces.size())});
    } else {
      const double sign = dot(cross(m_flat.normal(lower), m_flat.normal(higher)), d);
      flags |= sign > 0 ? Flat_mesh::CONVEX : sign < 0 ? Flat_mesh::CONCAVE : 0;
    }
    m_flat.m_higher_faces.push_back(higher);
    m_flat.m_lengths.push_back(norm(d));
    m_flat.m_flags.push_back(flags);
  }

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
  std::vector<Vector_3> m_points; // by iteration order
  std::vector<Degenerate_edge> m_degenerate_edges;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FLAT_MESH_BUILDER_H
