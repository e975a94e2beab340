// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPPORT_DOUBLE_3_H
#define CGAL_REGION_SEGMENTATION_SUPPORT_DOUBLE_3_H

#include <algorithm>
#include <cmath>
#include <cstdlib>

#if defined(__FAST_MATH__) || defined(_M_FP_FAST) ||                                               \
  (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "CGAL Region_segmentation: compile without -ffast-math, which removes checks of numbers"
#endif

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationData
/// A point or vector of three doubles, uninitialized by default. Once a mesh is read, all
/// computations are in double, independently of its kernel. It has the operators `a + b`, `a - b`
/// and `s * a`, and the functions `dot(a, b)`, `cross(a, b)`, `norm(a)` and `squared_norm(a)` in
/// the same namespace.
struct Double_3
{
  double x, y, z;
};

inline Double_3 operator-(const Double_3& a, const Double_3& b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Double_3 operator+(const Double_3& a, const Double_3& b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Double_3 operator*(double s, const Double_3& a)
{
  return {s * a.x, s * a.y, s * a.z};
}

inline double dot(const Double_3& a, const Double_3& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Double_3 cross(const Double_3& a, const Double_3& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double squared_norm(const Double_3& a)
{
  return dot(a, a);
}

/// The length of a vector. Coordinates of a `Surface` are scaled so that no square overflows.
inline double norm(const Double_3& a)
{
  return std::sqrt(squared_norm(a));
}

inline bool is_finite(const Double_3& a)
{
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
namespace internal {

/// The power of two by which coordinates are divided so that the largest of them is in [1, 2). The
/// division is exact, so results that do not depend on scale have the same bits, and areas stay in
/// the range of double. The result is 1 if squares of areas are in the range of double anyway, as
/// usual: then lengths are in units of the mesh.
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

#endif // CGAL_REGION_SEGMENTATION_SUPPORT_DOUBLE_3_H
