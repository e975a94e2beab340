// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TWO_STEP_GROW_REGIONS_H
#define CGAL_REGION_SEGMENTATION_TWO_STEP_GROW_REGIONS_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/edge_values.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationStages
/// grows regions between the feature edges of a surface: the connected components of the faces
/// across edges that are neither feature edges nor constrained (paper, section 3.2). Feature lines
/// that end inside the surface separate nothing, so they need not be removed before.
///
/// A degenerate face joins the region across its longest edge that is not constrained.
///
/// \param surface the surface
/// \param is_feature by adjacency: 1 for a feature edge, or 0; see `mark_feature_edges()`
/// \param execution sequential or parallel; reports the progress of the stage that it is of
/// \returns the regions of the faces
///
/// Complexity: O(F). Parallel with a parallel `execution`, with the same result.
inline Partition grow_regions(const Surface& surface, std::vector<std::uint8_t> is_feature,
                              const Execution& execution = Execution())
{
  internal::for_each_index(execution, is_feature.size(), [&](std::size_t a) {
    is_feature[a] |= surface.has_flag(a, Surface::barrier | Surface::CLOSED);
  });
  return internal::label_components(surface, is_feature.data(), 1, execution);
}

/// \ingroup PkgRegionSegmentationStages
/// grows regions between feature edges: the connected components of the faces across edges that are
/// not feature edges.
///
/// A degenerate face joins the region across its longest edge that is neither a border nor
/// constrained, unless the map marks this edge as a feature edge; growing does not cross its other
/// edges.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with TBB, `Parallel_tag`; see `segment()`
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`; also of
///         `EdgeListGraph` where there is an `edge_is_constrained_map`
/// \tparam EdgeIsFeatureMap a model of `ReadWritePropertyMap` with the edge descriptor as key and a
///         value type convertible to and constructible from `bool`
/// \tparam FaceRegionMap a model of `WritablePropertyMap` with the face descriptor as key and an
///         integral value type
/// \param mesh an oriented 2-manifold with or without boundary
/// \param edge_is_feature_map the feature edges; those between two faces of one region are cleared
///        unless they are constrained; borders of the mesh are set
/// \param region_map every key is written: ids 0 .. r-1, numbered by the first face
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{edges that are not crossed}
///     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor as key type and a
///       value type convertible to `bool`}
///     \cgalParamDefault{no edge}
///   \cgalParamNEnd
///   \cgalParamNBegin{component_links}
///     \cgalParamDescription{whether border edges with equal end points are one edge; other links
///       have no effect here}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the progress, and can cancel: stages "reading", "regions"}
///     \cgalParamType{a model of `SegmentationVisitor`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{passed by `std::ref()`}
///   \cgalParamNEnd
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
/// \cgalNamedParamsEnd
///
/// \returns the number r of regions
/// \post every region is connected; two faces that share an edge which is not a feature edge, and
///       neither of which is degenerate, have the same region
/// \throws Invalid_input if a point is not finite, Segmentation_cancelled if the visitor cancels;
///         the maps are unchanged
///
/// Complexity: O(F); 4 bytes per face. Deterministic. Parallel: reading, with `Parallel_tag`.
/// Concurrent calls on different maps are safe.
///
/// Source: \cgalCite{YZWLL14}, section 3.2.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph,
          typename EdgeIsFeatureMap, typename FaceRegionMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t grow_regions(const FaceGraph& mesh, EdgeIsFeatureMap edge_is_feature_map,
                         FaceRegionMap region_map,
                         const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Reading_parameters>();
  static_assert(internal::check_edge_map<EdgeIsFeatureMap, FaceGraph>());
  static_assert(internal::check_face_map<FaceRegionMap, FaceGraph>());
  const Execution execution = internal::make_execution<ConcurrencyTag>(pack);
  const Surface surface = internal::make_surface_with_sides(mesh, pack, execution);
  std::vector<std::uint8_t> is_feature = edge_values(mesh, surface, edge_is_feature_map);
  const Partition regions = grow_regions(surface, is_feature, execution.stage("regions"));
  for (std::size_t a = 0; a < is_feature.size(); ++a)
    is_feature[a] &= regions[surface.lower_face(a)] != regions[surface.higher_face(a)];

  write_face_values(mesh, regions, region_map);
  write_edge_values(mesh, surface, is_feature, edge_is_feature_map);
  return regions.number_of_parts();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TWO_STEP_GROW_REGIONS_H
