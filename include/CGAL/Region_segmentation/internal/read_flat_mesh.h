// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READ_FLAT_MESH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READ_FLAT_MESH_H

#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/Flat_mesh_builder.h>
#include <CGAL/Region_segmentation/internal/Mesh_walk.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Reads a face graph, once, into a `Flat_mesh`.
///
/// Faces are read in order. A dual edge is added with its higher face, when both normals are known; the
/// lower face has left room for as many as it has higher neighbors, and these come in order.
template <typename FaceGraph, typename Pack>
class Flat_mesh_reader
{
  using Walk = Mesh_walk<FaceGraph, Pack>;
  using Index = Flat_mesh::Index;
  using edge_descriptor = typename boost::graph_traits<FaceGraph>::edge_descriptor;
  using Point_map = typename GetVertexPointMap<FaceGraph, Pack>::const_type;

public:
  Flat_mesh_reader(const Walk& walk, const Pack& np, Flat_mesh::Content content)
    : m_mesh(walk.mesh())
    , m_walk(walk)
    , m_with_points(content == Flat_mesh::Content::ANGLES_AND_POINTS)
    , m_point_map(CGAL::parameters::choose_parameter(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
        get_const_property_map(vertex_point, walk.mesh())))
  {}

  /// \throws Invalid_input if a point is not finite
  template <typename EdgeIsConstrainedMap>
  Flat_mesh read(const EdgeIsConstrainedMap& is_constrained)
  {
    Flat_mesh_builder builder(m_walk.number_of_faces(), num_halfedges(m_mesh) / 2);
    read_points(builder);
    typename Walk::Boundary around;
    std::vector<Vector_3> polygon;
    std::size_t rank = 0;
    for (auto f : faces(m_mesh)) {
      m_walk.read_boundary(f, around);
      polygon.clear();
      std::size_t higher_neighbors = 0;
      for (std::size_t i = 0; i < around.size(); ++i) {
        polygon.push_back(point(source(around[i], m_mesh)));
        const std::size_t other = m_walk.opposite_face_rank(around[i]);
        higher_neighbors += other != Walk::no_face && other > rank;
      }
      builder.add_face(polygon, higher_neighbors);
      if (m_with_points)
        builder.add_corners(around.size(), [&](std::size_t i) { return m_walk.source_rank(around[i]); });
      for (std::size_t i = 0; i < around.size(); ++i)
        if (const std::size_t lower = m_walk.opposite_face_rank(around[i]); lower < rank) {
          // From the side of the lower face the edge runs the other way.
          const Vector_3 d = polygon[i] - polygon[i + 1 < polygon.size() ? i + 1 : 0];
          builder.add_edge(lower, rank, d, bool(get(is_constrained, edge(around[i], m_mesh))));
        }
      ++rank;
    }
    return builder.finish();
  }

private:
  Vector_3 point(typename boost::graph_traits<FaceGraph>::vertex_descriptor v) const
  {
    const auto& p = get(m_point_map, v);
    return {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
  }

  void read_points(Flat_mesh_builder& builder) const
  {
    std::size_t rank = 0;
    for (auto v : vertices(m_mesh)) {
      const Vector_3 p = point(v);
      if (!is_finite(p))
        throw Invalid_input("the point of vertex " + std::to_string(rank) + " is not finite");
      if (m_with_points)
        builder.add_point(p);
      ++rank;
    }
  }

  const FaceGraph& m_mesh;
  const Walk& m_walk;
  bool m_with_points;
  Point_map m_point_map;
};

/// The flat mesh of a face graph and its constrained edges.
/// \throws Invalid_input if a point is not finite
template <typename FaceGraph, typename Pack>
Flat_mesh read_flat_mesh(const Mesh_walk<FaceGraph, Pack>& walk, const Pack& np,
                         Flat_mesh::Content content = Flat_mesh::Content::ANGLES)
{
  using edge_descriptor = typename boost::graph_traits<FaceGraph>::edge_descriptor;
  return Flat_mesh_reader<FaceGraph, Pack>(walk, np, content).read(CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained),
    Static_boolean_property_map<edge_descriptor, false>()));
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READ_FLAT_MESH_H
