// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_WRITE_MAPS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_WRITE_MAPS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/reading/for_each_edge.h>
#include <CGAL/Region_segmentation/internal/support/Edge_marks.h>
#include <CGAL/Region_segmentation/internal/support/check_maps.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Writes every key of an edge map, and returns the number of edges written as true. `for_each_value(f)` calls
/// `f(edge, value)` for all edges in their order, each a `Mesh_edge`. If it may throw, the values are stored before they are written,
/// 1 byte per edge: then the map is unchanged.
template <typename FaceGraph, typename EdgeMap, typename ForEachValue>
std::size_t write_edge_map(const FaceGraph& mesh, EdgeMap& map, bool may_throw, const ForEachValue& for_each_value)
{
  static_assert(check_edge_map<EdgeMap, FaceGraph>());
  using Value = typename boost::property_traits<EdgeMap>::value_type;
  std::size_t count = 0;
  const auto write = [&map, &count](const auto& descriptor, bool value) {
    put(map, descriptor, Value(value));
    count += value;
  };
  if (!may_throw) {
    for_each_value([write](const Mesh_edge<FaceGraph>& e, bool value) { write(e.descriptor, value); });
    return count;
  }
  Edge_marks values(num_edges(mesh));
  for_each_value([&](const Mesh_edge<FaceGraph>& e, bool value) { values[e.rank] = value; });
  std::size_t rank = 0;
  for (auto e : edges(mesh))
    write(e, values[rank++] != 0);
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
