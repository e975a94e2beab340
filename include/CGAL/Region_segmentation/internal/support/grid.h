// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_GRID_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_GRID_H

#include <cmath>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

// Values that are equal but for rounding, as those of mirror images or of one shape in several
// frames, are compared on grids far above rounding and far below what matters. (The factors keep
// likely numbers, as 1/2, away from the borders between cells.)

/// A multiple of 2^-20 near `value`, less than 2^-20 away from it. Sums of such numbers are exact.
inline double on_grid(double value)
{
  constexpr double steps = 1 << 20;
  return std::floor(value * steps + 0.3819660112501051) / steps;
}

/// A number that is not negative as 20 bits, which are ordered like the numbers: they have a relative
/// precision of 2^-12.
inline std::uint32_t coarse_bits(double value)
{
  const float scaled = float(value * 1.1803398874989485);
  std::uint32_t bits;
  std::memcpy(&bits, &scaled, sizeof bits);
  return bits >> 11;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_GRID_H
