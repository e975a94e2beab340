// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TWO_STEP_DETECT_FEATURE_EDGES_H
#define CGAL_REGION_SEGMENTATION_TWO_STEP_DETECT_FEATURE_EDGES_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
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
/// sign is of the selected kind.
///
/// The *deviation* of an edge is the angle \f$\arccos(N_i \cdot N_j)\f$ between the unit normals of
/// its faces, \f$\pi - \theta\f$ for the dihedral angle \f$\theta\f$ (paper, eq. 1). Edges of a
/// degenerate face have no angle and are no feature edges. Borders of the surface have no
/// adjacency; they and constrained edges are feature edges for all stages that follow, and `true`
/// in a map that `write_edge_values()` writes.
///
/// \param surface the surface
/// \param maximum_angle the bound of the deviation, in degrees
/// \param convexity which edges can be feature edges
/// \param execution sequential or parallel; reports the progress of the stage that it is of
/// \returns by adjacency: 1 for a feature edge, or 0
/// \pre `maximum_angle` is in [0, 180]
///
/// Complexity: O(F). Deterministic. Parallel with a parallel `execution`.
///
/// Source: \cgalCite{YZWLL14}, section 3.1.
inline std::vector<std::uint8_t>
detect_feature_edges(const Surface& surface, double maximum_angle = default_maximum_angle,
                     Feature_convexity convexity = Feature_convexity::CONCAVE,
                     const Execution& execution = Execution())
{
  CGAL_precondition_msg(maximum_angle >= 0 && maximum_angle <= 180,
                        "maximum_angle is in [0, 180] degrees");
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

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TWO_STEP_DETECT_FEATURE_EDGES_H
