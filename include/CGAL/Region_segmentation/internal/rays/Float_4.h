// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_FLOAT_4_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_FLOAT_4_H

#include <array>
#include <cstdint>
#include <functional>

// Four floats, which gcc and clang process with one instruction, without a processor flag. (Loops over four are also
// vectorized, but not by every compiler and not wherever they are inlined.) Each lane is rounded as a float, so results
// do not depend on the implementation.
//
// With `std::array` instead (used with other compilers), the visibility of regions takes 1.6 times as long at 10,000
// faces and 1.4 times at 160,000, the entire default method 1.4 and 1.2 times.

namespace CGAL {
namespace Region_segmentation {
namespace internal {

#ifdef __GNUC__

using Float_4 = float __attribute__((vector_size(16)));
using Mask_4 = std::int32_t __attribute__((vector_size(16))); ///< not zero in a lane where something holds

inline Float_4 select(const Mask_4& mask, const Float_4& a, const Float_4& b)
{
  return mask ? a : b;
}

#else

struct Float_4 : std::array<float, 4>
{};
struct Mask_4 : std::array<std::int32_t, 4> ///< not zero in a lane where something holds
{};

template <typename Result, typename Four, typename F>
Result each_lane(const Four& a, const Four& b, const F& f)
{
  return {{f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])}};
}

// clang-format off
inline Float_4 operator+(const Float_4& a, const Float_4& b) { return each_lane<Float_4>(a, b, std::plus<>()); }
inline Float_4 operator-(const Float_4& a, const Float_4& b) { return each_lane<Float_4>(a, b, std::minus<>()); }
inline Float_4 operator*(const Float_4& a, const Float_4& b) { return each_lane<Float_4>(a, b, std::multiplies<>()); }
inline Float_4 operator/(const Float_4& a, const Float_4& b) { return each_lane<Float_4>(a, b, std::divides<>()); }
inline Mask_4 operator<(const Float_4& a, const Float_4& b) { return each_lane<Mask_4>(a, b, std::less<>()); }
inline Mask_4 operator>(const Float_4& a, const Float_4& b) { return each_lane<Mask_4>(a, b, std::greater<>()); }
inline Mask_4 operator<=(const Float_4& a, const Float_4& b) { return each_lane<Mask_4>(a, b, std::less_equal<>()); }
inline Mask_4 operator!=(const Float_4& a, const Float_4& b) { return each_lane<Mask_4>(a, b, std::not_equal_to<>()); }
inline Mask_4 operator&(const Mask_4& a, const Mask_4& b) { return each_lane<Mask_4>(a, b, std::bit_and<>()); }
inline Mask_4 operator|(const Mask_4& a, const Mask_4& b) { return each_lane<Mask_4>(a, b, std::bit_or<>()); }
// clang-format on

inline Float_4 select(const Mask_4& mask, const Float_4& a, const Float_4& b)
{
  return {{mask[0] ? a[0] : b[0], mask[1] ? a[1] : b[1], mask[2] ? a[2] : b[2], mask[3] ? a[3] : b[3]}};
}

#endif

inline Float_4 all_lanes(float value)
{
  return Float_4{value, value, value, value};
}

/// The smaller one; b where one of them is not a number.
inline Float_4 smaller(const Float_4& a, const Float_4& b)
{
  return select(a < b, a, b);
}

/// The larger one; b where one of them is not a number.
inline Float_4 larger(const Float_4& a, const Float_4& b)
{
  return select(a > b, a, b);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_FLOAT_4_H
