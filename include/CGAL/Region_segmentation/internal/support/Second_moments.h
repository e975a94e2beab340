// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SECOND_MOMENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SECOND_MOMENTS_H

#include <CGAL/Region_segmentation/Double_3.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A symmetric 3 x 3 matrix.
struct Symmetric_3
{
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  double trace() const { return xx + yy + zz; }

  double determinant() const
  {
    return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  }

  /// The sum of the products of two different eigenvalues.
  double second_invariant() const
  {
    return xx * yy + yy * zz + zz * xx - xy * xy - yz * yz - xz * xz;
  }

  /// v^T M v
  double along(const Double_3& v) const
  {
    return xx * v.x * v.x + yy * v.y * v.y + zz * v.z * v.z +
           2 * (xy * v.x * v.y + xz * v.x * v.z + yz * v.y * v.z);
  }

  /// Adds weight * v v^T.
  void add_square(double weight, const Double_3& v)
  {
    xx += weight * v.x * v.x;
    xy += weight * v.x * v.y;
    xz += weight * v.x * v.z;
    yy += weight * v.y * v.y;
    yz += weight * v.y * v.z;
    zz += weight * v.z * v.z;
  }

  void add(const Symmetric_3& other)
  {
    xx += other.xx;
    xy += other.xy;
    xz += other.xz;
    yy += other.yy;
    yz += other.yz;
    zz += other.zz;
  }
};

/// The trace of the product of two matrices.
inline double trace_of_product(const Symmetric_3& a, const Symmetric_3& b)
{
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2 * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}

/// The eigenvalues, the largest first, as the roots of the characteristic polynomial by Viete's
/// formula. The absolute error is below 1e-7 of the largest.
inline std::array<double, 3> eigenvalues(const Symmetric_3& m)
{
  const double mean = m.trace() / 3;
  const Symmetric_3 d{m.xx - mean, m.xy, m.xz, m.yy - mean, m.yz, m.zz - mean};
  const double radius = std::sqrt((std::max)(0.0, trace_of_product(d, d)) / 6);
  if (!(radius > 0))
    return {mean, mean, mean};
  const double cosine = d.determinant() / (2 * radius * radius * radius);
  const double angle = std::acos((std::max)(-1.0, (std::min)(1.0, cosine))) / 3; // in [0, pi / 3]
  const double first = mean + 2 * radius * std::cos(angle);
  const double last = mean + 2 * radius * std::cos(angle + 2 * CGAL_PI / 3);
  return {first, 3 * mean - first - last, last};
}

/// Weight, first and second moments of weighted points. They are sums: those of a union are the
/// sums of those of its parts.
struct Second_moments
{
  double weight = 0;
  Double_3 first{0, 0, 0};
  Symmetric_3 second;

  void add(double w, const Double_3& point)
  {
    weight += w;
    first = first + w * point;
    second.add_square(w, point);
  }

  void add(const Second_moments& other)
  {
    weight += other.weight;
    first = first + other.first;
    second.add(other.second);
  }

  /// The mean of the points; the origin if they have no weight.
  Double_3 centroid() const { return weight > 0 ? (1 / weight) * first : Double_3{0, 0, 0}; }

  /// The mean of the squares of the vectors from the centroid to the points; zero if they have no
  /// weight.
  Symmetric_3 covariance() const
  {
    if (!(weight > 0))
      return Symmetric_3();
    const double s = 1 / weight;
    Symmetric_3 result{s * second.xx, s * second.xy, s * second.xz,
                       s * second.yy, s * second.yz, s * second.zz};
    result.add_square(-1, centroid());
    return result;
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SECOND_MOMENTS_H
