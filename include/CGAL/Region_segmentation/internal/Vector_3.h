// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_VECTOR_3_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_VECTOR_3_H

#include <boost/config.hpp>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Three doubles; as such not initialized. After a mesh is read, every computation is in double, whatever its kernel.
struct Vector_3
{
  double x, y, z;
};

inline Vector_3 operator-(const Vector_3& a, const Vector_3& b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Vector_3 operator+(const Vector_3& a, const Vector_3& b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Vector_3 operator*(double s, const Vector_3& a)
{
  return {s * a.x, s * a.y, s * a.z};
}

inline double dot(const Vector_3& a, const Vector_3& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vector_3 cross(const Vector_3& a, const Vector_3& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double squared_norm(const Vector_3& a)
{
  return dot(a, a);
}

inline bool is_finite(const Vector_3& a)
{
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Whether the square of a length tells the length: the square of a component may leave the range of double where
/// the length does not.
inline bool is_square_of_norm(double square)
{
  return square > 1e-280 && square < std::numeric_limits<double>::infinity();
}

BOOST_NOINLINE inline double norm_far_from_1(const Vector_3& a)
{
  return std::hypot(a.x, a.y, a.z);
}

/// The length.
inline double norm(const Vector_3& a)
{
  const double square = squared_norm(a);
  return is_square_of_norm(square) ? std::sqrt(square) : norm_far_from_1(a);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_VECTOR_3_H
