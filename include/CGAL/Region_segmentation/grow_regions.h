// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GROW_REGIONS_H
#define CGAL_REGION_SEGMENTATION_GROW_REGIONS_H

#include <CGAL/Region_segmentation/internal/read_flat_mesh.h>
#include <CGAL/Region_segmentation/internal/label_components.h>
#include <CGAL/Region_segmentation/internal/write_maps.h>
#include <CGAL/Region_segmentation/parameters.h>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationInitializers
/// The paper's maker of regions: the connected components of the faces across edges that are not
/// feature edges. A model of `RegionInitializer`.
struct Region_growing
{
  template <typename ConcurrencyTag = CGAL::Sequential_tag>
  Region_labels operator()(const Flat_mesh& flat, const Edge_marks& is_feature,
                           ConcurrencyTag = ConcurrencyTag()) const
  {
    return internal::label_components<ConcurrencyTag>(flat, is_feature);
  }
};

/// \ingroup PkgRegionSegmentationStages
/// grows regions between feature edges: the connected components of the faces across edges that are
/// not feature edges.
///
/// A degenerate face joins the region across its longest edge that is neither a border nor
/// constrained, unless the map says that this is a feature edge; its other edges are no way for
/// growing.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with \ref thirdpartyTBB, `Parallel_tag`; see `segment()`
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsFeatureMap a model of `ReadWritePropertyMap` with the edge descriptor as key and a
///         value type convertible to and constructible from `bool`
/// \tparam FaceRegionMap a model of `WritablePropertyMap` with the face descriptor as key and an
///         integral value type
/// \param mesh an oriented 2-manifold with or without borders
/// \param edge_is_feature_map the feature edges; those between two faces of one region are cleared
///        unless they are constrained, borders of the mesh are set
/// \param region_map every key is written: ids 0 .. r-1, numbered by the first face
/// \param np optional named parameters:
///   - `edge_is_constrained_map`: edges that are not crossed (default: none)
///   - `vertex_point_map`, `face_index_map`, `vertex_index_map`: as everywhere in \cgal
///
/// \returns the number r of regions
/// \post every region is connected; two faces that share an edge which is not a feature edge, and
///       neither of which is degenerate, have the same region
/// \throws Invalid_input if a point is not finite; the maps are as before then
///
/// Complexity: O(F). Deterministic. Calls on different maps may run at the same time.
///
/// Source: Yang et al. 2014, section 3.2.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph, typename EdgeIsFeatureMap,
          typename FaceRegionMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t grow_regions(const FaceGraph& mesh, EdgeIsFeatureMap edge_is_feature_map,
                         FaceRegionMap region_map,
                         const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  const auto walk = internal::make_mesh_walk(mesh, pack);
  const Flat_mesh flat = internal::read_flat_mesh<ConcurrencyTag>(walk, pack);
  Edge_marks is_feature = internal::read_edge_map(walk, flat, edge_is_feature_map);
  const Region_labels regions = Region_growing()(flat, is_feature, ConcurrencyTag());
  internal::clear_marks_within_regions<ConcurrencyTag>(flat, regions, is_feature);

  internal::write_edge_map(walk, is_feature, edge_is_feature_map);
  internal::write_face_map(walk, region_map, [&](std::size_t i) { return regions.of_face[i]; });
  return regions.number_of_regions;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GROW_REGIONS_H
