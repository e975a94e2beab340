// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_UNIT_OF_COORDINATES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_UNIT_OF_COORDINATES_H

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The power of two by which coordinates are divided so that the largest of them is in [1, 2): the
/// division is exact, so results that do not depend on scale are bitwise the same, and areas stay
/// in the range of double. But 1 if squares of areas are in the range of double: then lengths are
/// in units of the mesh, which is the usual case.
inline double unit_of_coordinates(double largest_coordinate)
{
  constexpr int lowest_exponent = -1000; // the inverse of the result is finite
  if (!(largest_coordinate > 0))
    return 1;
  const int exponent = (std::max)(std::ilogb(largest_coordinate), lowest_exponent);
  return std::abs(exponent) <= 64 ? 1 : std::ldexp(1.0, exponent);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_UNIT_OF_COORDINATES_H
