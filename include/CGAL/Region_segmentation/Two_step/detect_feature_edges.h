// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TWO_STEP_DETECT_FEATURE_EDGES_H
#define CGAL_REGION_SEGMENTATION_TWO_STEP_DETECT_FEATURE_EDGES_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/edge_values.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationStages
/// Which edges can be feature edges, by the sign of \f$(N_i \times N_j) \cdot d\f$, where \f$d\f$
/// points along the halfedge of the first face. An edge whose sign is exactly 0 is selected by
/// `ALL` only.
enum class Feature_convexity {
  CONVEX,  ///< ridges
  CONCAVE, ///< valleys: the joints of scanned and organic models
  ALL      ///< both: machine parts
};

/// \ingroup PkgRegionSegmentationStages
/// The bound of the paper, 3.12 rad for the dihedral angle, as a deviation: 1.2372... degrees.
inline constexpr double default_maximum_angle = 180 - 3.12 * (180 / CGAL_PI);

/// \ingroup PkgRegionSegmentationStages
/// marks the feature edges of a surface: the adjacencies whose deviation exceeds a bound and whose
/// sign is of the selected kind (paper, section 3.1). See `detect_feature_edges()`, which marks
/// borders and constrained edges as well.
///
/// \param surface the surface
/// \param maximum_angle the bound of the deviation, in degrees, in [0, 180]
/// \param convexity which edges can be feature edges
/// \param execution sequential or parallel; reports the progress of the stage that it is of
/// \returns by adjacency: 1 for a feature edge, or 0
///
/// Complexity: O(F). Parallel with a parallel `execution`.
inline std::vector<std::uint8_t>
mark_feature_edges(const Surface& surface, double maximum_angle = default_maximum_angle,
                   Feature_convexity convexity = Feature_convexity::CONCAVE,
                   const Execution& execution = Execution())
{
  const double bound = std::cos(maximum_angle * (CGAL_PI / 180));
  const std::uint8_t signs = convexity == Feature_convexity::CONVEX    ? Surface::CONVEX
                             : convexity == Feature_convexity::CONCAVE ? Surface::CONCAVE
                                                                       : 0;
  std::vector<std::uint8_t> is_feature(surface.number_of_adjacencies());
  internal::for_each_index(execution, is_feature.size(), [&](std::size_t a) {
    is_feature[a] = (signs == 0 || surface.has_flag(a, signs)) && surface.has_angle(a) &&
                    surface.cosine(a) < bound;
  });
  return is_feature;
}

namespace internal {
using Feature_edge_parameters = Tag_list<
  CGAL::internal_np::maximum_angle_t, internal_np::feature_convexity_t,
  internal_np::component_links_t, CGAL::internal_np::edge_is_constrained_t,
  CGAL::internal_np::visitor_t>;
}

/// \ingroup PkgRegionSegmentationStages
/// marks the feature edges of a mesh: its borders, its constrained edges, and those whose deviation
/// exceeds a bound and whose sign is of the selected kind.
///
/// The *deviation* of an edge is the angle \f$\arccos(N_i \cdot N_j)\f$ between the unit normals of
/// its faces, \f$\pi - \theta\f$ for the dihedral angle \f$\theta\f$ (paper, eq. 1). Edges of a
/// degenerate face have no angle and are no feature edges, unless they are borders or constrained.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with TBB, `Parallel_tag`; see `segment()`
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`; also of
///         `EdgeListGraph` where there is an `edge_is_constrained_map`
/// \tparam EdgeIsFeatureMap a model of `WritablePropertyMap` with the edge descriptor as key and a
///         value type that is constructible from `bool`
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param edge_is_feature_map every key is written
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_angle}
///     \cgalParamDescription{the bound of the deviation, in degrees}
///     \cgalParamType{`double`; from 0 to 180}
///     \cgalParamDefault{`default_maximum_angle`, 1.2372...}
///   \cgalParamNEnd
///   \cgalParamNBegin{feature_convexity}
///     \cgalParamDescription{which edges can be feature edges}
///     \cgalParamType{`Feature_convexity`}
///     \cgalParamDefault{`Feature_convexity::CONCAVE`}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{edges that are always feature edges}
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
///     \cgalParamDescription{follows the progress, and can cancel: stages "reading", "features"}
///     \cgalParamType{a model of `SegmentationVisitor`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{passed by `std::ref()`}
///   \cgalParamNEnd
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
/// \cgalNamedParamsEnd
///
/// \returns the number of edges written as true
/// \pre `maximum_angle` is in [0, 180]
/// \throws Invalid_input if a point is not finite, Segmentation_cancelled if the visitor cancels;
///         the map is unchanged
///
/// Complexity: O(F); that of `make_surface()`. Deterministic. Parallel with `Parallel_tag`.
/// Concurrent calls on different maps are safe.
///
/// Source: \cgalCite{YZWLL14}, section 3.1.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph,
          typename EdgeIsFeatureMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t detect_feature_edges(const FaceGraph& mesh, EdgeIsFeatureMap edge_is_feature_map,
                                 const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Feature_edge_parameters>();
  static_assert(internal::check_edge_map<EdgeIsFeatureMap, FaceGraph>());
  const Execution execution = internal::make_execution<ConcurrencyTag>(pack);
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const double maximum_angle = choose_parameter(
    get_parameter(pack, CGAL::internal_np::maximum_angle), default_maximum_angle);
  CGAL_precondition_msg(maximum_angle >= 0 && maximum_angle <= 180,
                        "maximum_angle is in [0, 180] degrees");
  const Feature_convexity convexity = choose_parameter(
    get_parameter(pack, internal_np::feature_convexity), Feature_convexity::CONCAVE);
  const Surface surface = internal::make_surface_with_sides(mesh, pack, execution);
  return write_edge_values(
    mesh, surface,
    mark_feature_edges(surface, maximum_angle, convexity, execution.stage("features")),
    edge_is_feature_map);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TWO_STEP_DETECT_FEATURE_EDGES_H
