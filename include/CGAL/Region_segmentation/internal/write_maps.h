// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_WRITE_MAPS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_WRITE_MAPS_H

#include <CGAL/Region_segmentation/Merge_tree.h>
#include <CGAL/Region_segmentation/internal/Mesh_walk.h>
#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/label_components.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Writes every key of an edge map: the marks of dual edges, true for borders of the mesh, false for
/// an edge that has the same face on both sides. Returns the number of edges written as true.
template <typename FaceGraph, typename Pack, typename EdgeMap>
std::size_t write_edge_map(const Mesh_walk<FaceGraph, Pack>& walk, const Edge_marks& marks, EdgeMap& map)
{
  using Value = typename boost::property_traits<EdgeMap>::value_type;
  const FaceGraph& mesh = walk.mesh();
  std::size_t count = 0;
  for (auto e : edges(mesh)) {
    const bool is_border = CGAL::is_border(e, mesh);
    put(map, e, Value(is_border));
    count += is_border;
  }
  walk.for_each_dual_edge([&](auto h, std::size_t dual_edge) {
    if (!marks[dual_edge])
      return;
    put(map, edge(h, mesh), Value(true));
    ++count;
  });
  return count;
}

/// The marks of the dual edges, read from an edge map.
template <typename FaceGraph, typename Pack, typename EdgeMap>
Edge_marks read_edge_map(const Mesh_walk<FaceGraph, Pack>& walk, const Flat_mesh& flat,
                         const EdgeMap& map)
{
  Edge_marks marks(flat.number_of_edges());
  walk.for_each_dual_edge([&](auto h, std::size_t dual_edge) {
    marks[dual_edge] =
      bool(get(map, edge(h, walk.mesh()))) || flat.has_flag(dual_edge, Flat_mesh::CONSTRAINED);
  });
  return marks;
}

/// Writes every key of a face map; `label(i)` is the value of the i-th face.
template <typename FaceGraph, typename Pack, typename FaceMap, typename Label>
void write_face_map(const Mesh_walk<FaceGraph, Pack>& walk, FaceMap& map, const Label& label)
{
  using Value = typename boost::property_traits<FaceMap>::value_type;
  std::size_t i = 0;
  walk.for_each_face([&](const auto& face) { put(map, face, Value(label(i++))); });
}

/// Writes what led to a segmentation to the outputs that a pack asks for. The marks of edges within regions are
/// cleared if they are asked for.
template <typename ConcurrencyTag, typename FaceGraph, typename Pack>
void write_segmentation_outputs(const Mesh_walk<FaceGraph, Pack>& walk, const Flat_mesh& flat,
                                const Region_labels& regions, Edge_marks& is_feature, const Merge_tree& tree,
                                const Pack& np)
{
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::get_parameter_reference;
  using CGAL::parameters::is_default_parameter;
  if constexpr (!is_default_parameter<Pack, internal_np::region_map_t>::value) {
    auto map = get_parameter(np, internal_np::region_map);
    write_face_map(walk, map, [&](std::size_t i) { return regions.of_face[i]; });
  }
  if constexpr (!is_default_parameter<Pack, internal_np::edge_is_feature_map_t>::value) {
    auto map = get_parameter(np, internal_np::edge_is_feature_map);
    clear_marks_within_regions<ConcurrencyTag>(flat, regions, is_feature);
    write_edge_map(walk, is_feature, map);
  }
  if constexpr (!is_default_parameter<Pack, internal_np::merge_tree_t>::value) {
    Merge_tree& output = get_parameter_reference(np, internal_np::merge_tree);
    output = tree;
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_WRITE_MAPS_H
