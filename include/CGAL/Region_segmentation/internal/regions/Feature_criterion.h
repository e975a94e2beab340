// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_FEATURE_CRITERION_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_FEATURE_CRITERION_H

#include <CGAL/Region_segmentation/Feature_convexity.h>
#include <CGAL/Region_segmentation/Surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Which edges between two faces are feature edges by their deviation and their sign. Only cosines are compared.
class Feature_criterion
{
public:
  /// `maximum_angle`: in degrees
  Feature_criterion(double maximum_angle, Feature_convexity convexity)
    : m_bound(std::cos(maximum_angle * (CGAL_PI / 180)))
    , m_wanted_signs(convexity == Feature_convexity::CONVEX    ? Surface::CONVEX
                     : convexity == Feature_convexity::CONCAVE ? Surface::CONCAVE
                                                               : 0)
  {}

  /// An edge is sharp if its cosine is below it.
  double bound() const { return m_bound; }
  /// Rounding may bring the cosine below -1. False if it is not a number.
  bool is_sharp(double cosine) const { return (std::max)(cosine, -1.0) < m_bound; }

  bool wants_every_sign() const { return m_wanted_signs == 0; }
  /// Of an edge with these flags.
  bool has_wanted_sign(std::uint8_t flags) const { return wants_every_sign() || (flags & m_wanted_signs) != 0; }

private:
  double m_bound;
  std::uint8_t m_wanted_signs; // 0: whatever the sign
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_FEATURE_CRITERION_H
