// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_WRITE_MAPS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_WRITE_MAPS_H

#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/support/check_maps.h>
#include <CGAL/Region_segmentation/internal/support/Edge_marks.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Writes every key of an edge map: the marks of dual edges, true for borders of the mesh, false for
/// an edge that has the same face on both sides. Returns the number of edges written as true.
template <typename FaceGraph, typename Pack, typename EdgeMap>
std::size_t write_edge_map(const Mesh_traversal<FaceGraph, Pack>& traversal, const Edge_marks& marks, EdgeMap& map)
{
  static_assert(check_edge_map<EdgeMap, FaceGraph>());
  using Value = typename boost::property_traits<EdgeMap>::value_type;
  const FaceGraph& mesh = traversal.mesh();
  std::size_t count = 0;
  for (auto e : edges(mesh)) {
    const bool is_border = CGAL::is_border(e, mesh);
    put(map, e, Value(is_border));
    count += is_border;
  }
  traversal.for_each_dual_edge([&](auto h, std::size_t dual_edge) {
    if (!marks[dual_edge])
      return;
    put(map, edge(h, mesh), Value(true));
    ++count;
  });
  return count;
}

/// The marks of the dual edges, read from an edge map.
template <typename FaceGraph, typename Pack, typename EdgeMap>
Edge_marks read_edge_map(const Mesh_traversal<FaceGraph, Pack>& traversal, const Flat_mesh& flat,
                         const EdgeMap& map)
{
  static_assert(check_edge_map<EdgeMap, FaceGraph>());
  Edge_marks marks(flat.number_of_edges());
  traversal.for_each_dual_edge([&](auto h, std::size_t dual_edge) {
    marks[dual_edge] =
      bool(get(map, edge(h, traversal.mesh()))) || flat.has_flag(dual_edge, Flat_mesh::CONSTRAINED);
  });
  return marks;
}

/// Writes every key of a face map: `values[i]` for the i-th face. (Faster than `write_face_values()` where the traversal
/// has a list of the faces.)
template <typename FaceGraph, typename Pack, typename FaceMap, typename Values>
void write_face_map(const Mesh_traversal<FaceGraph, Pack>& traversal, FaceMap& map, const Values& values)
{
  static_assert(check_face_map<FaceMap, FaceGraph>());
  using Value = typename boost::property_traits<FaceMap>::value_type;
  std::size_t i = 0;
  traversal.for_each_face([&](const auto& face) { put(map, face, Value(values[i++])); });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_WRITE_MAPS_H
