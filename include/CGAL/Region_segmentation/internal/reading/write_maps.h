// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_WRITE_MAPS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_WRITE_MAPS_H

#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/support/check_maps.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Writes every key of an edge map: whether `is_true(rank)`, the rank being that in the order of edges. Returns the number
/// of edges written as true.
template <typename FaceGraph, typename EdgeMap, typename IsTrue>
std::size_t write_edge_map(const FaceGraph& mesh, EdgeMap& map, const IsTrue& is_true)
{
  static_assert(check_edge_map<EdgeMap, FaceGraph>());
  using Value = typename boost::property_traits<EdgeMap>::value_type;
  std::size_t rank = 0, count = 0;
  for (auto e : edges(mesh)) {
    const bool value = is_true(rank++);
    put(map, e, Value(value));
    count += value;
  }
  return count;
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
