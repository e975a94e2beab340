// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PARTITION_INTO_SEGMENTS_H
#define CGAL_REGION_SEGMENTATION_PARTITION_INTO_SEGMENTS_H

#include <CGAL/Region_segmentation/Merge_tree.h>
#include <CGAL/Region_segmentation/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Sight.h>
#include <CGAL/Region_segmentation/Superfacets.h>
#include <CGAL/Region_segmentation/internal/build_graph.h>
#include <CGAL/Region_segmentation/internal/concept_checks.h>
#include <CGAL/Region_segmentation/internal/options.h>
#include <CGAL/Region_segmentation/internal/read_flat_mesh.h>
#include <CGAL/Region_segmentation/internal/write_maps.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

namespace internal {

template <typename T, typename Graph>
using Partitions = std::enable_if_t<std::is_convertible<
  decltype(std::declval<const T&>()(std::declval<const Graph&>(), std::size_t())),
  Merge_tree::Segmentation>::value>;

template <typename T, typename Graph>
void check_graph_partitioner()
{
  static_assert(satisfies<Partitions, T, Graph>,
                "a GraphPartitioner needs: Merge_tree::Segmentation operator()(const Graph&, "
                "std::size_t number_of_segments) const");
}

} // namespace internal

/// \ingroup PkgRegionSegmentationStages
/// segments a surface mesh by a partitioner of its region graph: the regions are those of `Superfacets`,
/// and the graph is annotated by `Sight`.
///
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam FaceSegmentMap a model of `WritablePropertyMap` with the face descriptor as key and an
///         integral value type that holds the number of segments
/// \tparam Partitioner a model of `GraphPartitioner`
/// \param mesh an oriented 2-manifold with or without borders, its faces polygons of any size
/// \param segment_map every key is written: ids 0 .. n-1, numbered by the first face
/// \param partitioner deals the regions out
/// \param np named parameters:
///   - `number_of_segments` (at least 1): the wanted number; it has no default
///   - `edge_is_constrained_map`: edges that always are borders (default: none)
///   - `vertex_point_map`, `face_index_map`, `vertex_index_map`: as everywhere in \cgal
///
/// \returns the number n of segments
/// \throws Invalid_input if a point is not finite; the map is as before then
///
/// Complexity: O(F log F) in practice, and that of the partitioner for 800 regions. Deterministic if the
/// partitioner is. Calls on different maps may run at the same time.
template <typename FaceGraph, typename FaceSegmentMap, typename Partitioner, typename NamedParameters>
std::size_t partition_into_segments(const FaceGraph& mesh, FaceSegmentMap segment_map,
                                    const Partitioner& partitioner, const NamedParameters& np)
{
  using Graph = Region_adjacency_graph<Part_data, Cut_data>;
  internal::check_graph_partitioner<Partitioner, Graph>();
  const auto& pack = internal::pack(np);
  static_assert(!CGAL::parameters::is_default_parameter<std::decay_t<decltype(pack)>,
                                                        internal_np::number_of_segments_t>::value,
                "partition_into_segments() needs the named parameter number_of_segments");
  const std::size_t wanted = internal::number_of_segments(pack, 1);

  const auto walk = internal::make_mesh_walk(mesh, pack);
  const Flat_mesh flat =
    internal::read_flat_mesh(walk, pack, Flat_mesh::Content::ANGLES_AND_POINTS);
  const Region_labels regions = Superfacets()(flat, Edge_marks());
  auto graph = internal::build_graph<Graph>(flat, regions);
  Sight()(graph, flat, regions);
  const Merge_tree::Segmentation segments = partitioner(graph, wanted);

  internal::write_face_map(walk, segment_map,
                           [&](std::size_t i) { return segments.of_region[regions.of_face[i]]; });
  return segments.number_of_segments;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PARTITION_INTO_SEGMENTS_H
