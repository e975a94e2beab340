// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_SEAM_COST_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_SEAM_COST_H

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// The cost of a seam: the sum over its edges of \f$l / (1 + g \, \delta^+)\f$, \f$l\f$ the length
/// and \f$\delta^+\f$ the deviation of a concave edge (0 of another one), in radians. So seams are
/// short, and hidden in valleys.
struct Seam_cost
{
  double concave_gain = 10; ///< g, in 1/radian, at least 0. 0: seams are as short as possible
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_SEAM_COST_H
