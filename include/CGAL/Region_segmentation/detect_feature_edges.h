// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_DETECT_FEATURE_EDGES_H
#define CGAL_REGION_SEGMENTATION_DETECT_FEATURE_EDGES_H

#include <CGAL/Region_segmentation/Feature_convexity.h>
#include <CGAL/Region_segmentation/internal/read_flat_mesh.h>
#include <CGAL/Region_segmentation/internal/mark_feature_edges.h>
#include <CGAL/Region_segmentation/internal/options.h>
#include <CGAL/Region_segmentation/internal/write_maps.h>
#include <CGAL/Region_segmentation/parameters.h>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationStages
/// marks the feature edges of a mesh: its borders, the edges that are constrained, and those whose
/// deviation is above a bound and whose sign is of the wanted kind.
///
/// The *deviation* of an edge is the angle \f$\arccos(N_i \cdot N_j)\f$ between the unit normals of
/// its faces, \f$\pi - \theta\f$ for the dihedral angle \f$\theta\f$ (paper, eq. 1). Edges of a
/// degenerate face have no angle and are no feature edges, unless they are borders or constrained.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with \ref thirdpartyTBB, `Parallel_tag`; see `segment()`
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsFeatureMap a model of `WritablePropertyMap` with the edge descriptor as key and a
///         value type that is constructible from `bool`
/// \param mesh an oriented 2-manifold with or without borders, its faces polygons of any size
/// \param edge_is_feature_map every key is written
/// \param np optional named parameters:
///   - `maximum_angle` (degrees, default 180 - 3.12 * 180 / pi = 1.2376...): the bound
///   - `feature_convexity` (`Feature_convexity`, default `CONCAVE`): the wanted kind
///   - `edge_is_constrained_map`: edges that always are feature edges (default: none)
///   - `vertex_point_map`, `face_index_map`, `vertex_index_map`: as everywhere in \cgal
///
/// \returns the number of edges written as true
/// \pre `maximum_angle` is in [0, 180]
/// \throws Invalid_input if a point is not finite; the map is as before then
///
/// Complexity: O(F). Deterministic. Calls on different maps may run at the same time.
///
/// Source: Yang et al. 2014, section 3.1.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph, typename EdgeIsFeatureMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t detect_feature_edges(const FaceGraph& mesh, EdgeIsFeatureMap edge_is_feature_map,
                                 const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  const auto walk = internal::make_mesh_walk(mesh, pack);
  const Flat_mesh flat = internal::read_flat_mesh<ConcurrencyTag>(walk, pack);
  const Edge_marks is_feature = internal::mark_feature_edges<ConcurrencyTag>(
    flat, internal::maximum_angle(pack), internal::feature_convexity(pack));
  return internal::write_edge_map(walk, is_feature, edge_is_feature_map);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_DETECT_FEATURE_EDGES_H
