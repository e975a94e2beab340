// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_FEATURE_CONVEXITY_H
#define CGAL_REGION_SEGMENTATION_FEATURE_CONVEXITY_H

#include <CGAL/number_type_config.h>

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

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_FEATURE_CONVEXITY_H
