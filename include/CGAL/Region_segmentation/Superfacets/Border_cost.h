// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_BORDER_COST_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_BORDER_COST_H

#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationParts
/// What a border costs: \f$l / (1 + g \, \min(\delta^+, m))\f$, \f$l\f$ its length in units of the
/// square root of the area of the surface, \f$\delta^+\f$ the deviation across it where it is
/// concave, else 0. So borders are drawn into valleys.
struct Border_cost
{
  double concave_gain = 10; ///< g, 1/radian, at least 0: how much cheaper a border in a valley is
  double maximum_deviation = 0.6; ///< m, radian, at least 0: deviations above it count as this one

  /// \throws Invalid_method if a constant is not in its range
  void check_constants() const
  {
    internal::check_constant("Border_cost: concave_gain", concave_gain, 0);
    internal::check_constant("Border_cost: maximum_deviation", maximum_deviation, 0);
  }

  double operator()(double length, double concave_deviation) const
  {
    return length / (1 + concave_gain * (std::min)(concave_deviation, maximum_deviation));
  }
};

/// \ingroup PkgRegionSegmentationParts
/// How borders are moved to minimum cuts: in a band of the width
/// \f$\min(D_0, q \sqrt{a})\f$ on either side, \f$a\f$ the smaller of the two areas, so that the
/// cost of the border is lowest. Lengths are in units of the square root of the area of the
/// surface, areas in units of this area.
struct Minimum_cut_borders
{
  double width = 0.03;           ///< D_0, at least 0
  double width_of_segment = 0.2; ///< q, at least 0
  Border_cost cost = {Border_cost().concave_gain, CGAL_PI};

  /// \throws Invalid_method if a constant is not in its range
  void check_constants() const
  {
    internal::check_constant("Minimum_cut_borders: width", width, 0);
    internal::check_constant("Minimum_cut_borders: width_of_segment", width_of_segment, 0);
    cost.check_constants();
  }

  /// The width of the band by the smaller area.
  double band_width(double area) const
  {
    return (std::min)(width, width_of_segment * std::sqrt(area));
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_BORDER_COST_H
