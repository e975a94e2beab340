// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SHARE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SHARE_H

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// a / (a + b) for non-negative numbers, in [0, 1]; 1/2 where both are 0.
inline double share(double a, double b)
{
  return a + b == 0 ? 0.5 : a / (a + b);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SHARE_H
