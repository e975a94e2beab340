// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_BUILD_REGION_ADJACENCY_GRAPH_H
#define CGAL_REGION_SEGMENTATION_BUILD_REGION_ADJACENCY_GRAPH_H

#include <CGAL/Region_segmentation/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/internal/read_flat_mesh.h>
#include <CGAL/Region_segmentation/internal/build_graph.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationStages
/// builds the graph of the regions of a mesh and the sections between them.
///
/// \tparam Graph a `Region_adjacency_graph`, with data of any kind
/// \tparam ConcurrencyTag `Sequential_tag` or, with \ref thirdpartyTBB, `Parallel_tag`; see `segment()`
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam FaceRegionMap a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type
/// \param mesh an oriented 2-manifold with or without borders
/// \param region_map the region of every face: ids 0 .. r-1, from whatever maker of regions
/// \param np optional named parameters:
///   - `edge_is_constrained_map`: edges that are never merged across (default: none)
///   - `vertex_point_map`, `face_index_map`, `vertex_index_map`: as everywhere in \cgal
///
/// \pre the ids are from 0 and dense: their number is the largest id + 1
/// \throws Invalid_input if a point is not finite
///
/// Complexity: O(F) where regions are connected and the surface has few handles, O(F sqrt(F)) at worst.
/// Deterministic: the sums over the edges of a section run by lower, then by higher face, whatever the mesh
/// type.
///
/// Source: Yang et al. 2014, section 3.3 (EdgeSection).
template <typename Graph = Region_adjacency_graph<>, typename ConcurrencyTag = CGAL::Sequential_tag,
          typename FaceGraph, typename FaceRegionMap,
          typename NamedParameters = parameters::Default_named_parameters>
Graph build_region_adjacency_graph(const FaceGraph& mesh, FaceRegionMap region_map,
                                   const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  const auto walk = internal::make_mesh_walk(mesh, pack);
  const Flat_mesh flat = internal::read_flat_mesh<ConcurrencyTag>(walk, pack);
  Region_labels regions;
  regions.of_face.reserve(flat.number_of_faces());
  for (auto f : faces(mesh)) {
    const auto id = get(region_map, f);
    CGAL_precondition_msg(id >= 0 && std::size_t(id) < flat.number_of_faces(),
                          "ids of regions are from 0 and dense");
    regions.of_face.push_back(Flat_mesh::Index(id));
    regions.number_of_regions = (std::max)(regions.number_of_regions, std::size_t(id) + 1);
  }
  return internal::build_graph<Graph, ConcurrencyTag>(flat, regions);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_BUILD_REGION_ADJACENCY_GRAPH_H
