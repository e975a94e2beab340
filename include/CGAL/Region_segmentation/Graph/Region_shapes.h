// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_REGION_SHAPES_H
#define CGAL_REGION_SEGMENTATION_GRAPH_REGION_SHAPES_H

#include <CGAL/Region_segmentation/Graph/Patches.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationData
/// A symmetric 3 x 3 matrix.
struct Symmetric_3
{
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  double trace() const { return xx + yy + zz; }

  double determinant() const
  {
    return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
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

  /// Adds another matrix.
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

namespace internal {

/// The trace of the product of two matrices.
inline double trace_of_product(const Symmetric_3& a, const Symmetric_3& b)
{
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2 * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}

/// 1 / area; 0 if the area is so small that this would be infinite.
inline double inverse(double area)
{
  return area >= (std::numeric_limits<double>::min)() ? 1 / area : 0;
}

} // namespace internal

/// \relates Symmetric_3
/// The eigenvalues, the largest first, as the roots of the characteristic polynomial by Viete's
/// formula. The absolute error is below 1e-7 of the largest.
inline std::array<double, 3> eigenvalues(const Symmetric_3& m)
{
  const double mean = m.trace() / 3;
  const Symmetric_3 d{m.xx - mean, m.xy, m.xz, m.yy - mean, m.yz, m.zz - mean};
  const double radius = std::sqrt((std::max)(0.0, internal::trace_of_product(d, d)) / 6);
  if (!(radius > 0))
    return {mean, mean, mean};
  const double cosine = d.determinant() / (2 * radius * radius * radius);
  const double angle = std::acos((std::max)(-1.0, (std::min)(1.0, cosine))) / 3; // in [0, pi / 3]
  const double first = mean + 2 * radius * std::cos(angle);
  const double last = mean + 2 * radius * std::cos(angle + 2 * CGAL_PI / 3);
  return {first, 3 * mean - first - last, last};
}

/// \ingroup PkgRegionSegmentationData
/// Weight, first and second moments of weighted points. They are sums: those of a union are the
/// sums of those of its parts.
struct Second_moments
{
  double weight = 0;
  Double_3 first{0, 0, 0}; ///< the sum of the points, weighted
  Symmetric_3 second;      ///< the sum of their squares p p^T, weighted

  /// Adds a point of weight w.
  void add(double w, const Double_3& point)
  {
    weight += w;
    first = first + w * point;
    second.add_square(w, point);
  }

  /// Adds the points of other moments.
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

/// \ingroup PkgRegionSegmentationData
/// The shape of a region: the sums of `Learned_annotator`; zero for a surface without area.
struct Region_shape
{
  Double_3 area_vector{0, 0, 0}; ///< the integral of the normal, as a share of the area of the
                                 ///< surface
  Second_moments moments;        ///< of the area, relative to `Region_shapes::origin`

  /// Of length 1, or zero.
  Double_3 normal() const
  {
    const double length = norm(area_vector);
    return length > 0 ? (1 / length) * area_vector : Double_3{0, 0, 0};
  }
};

/// \ingroup PkgRegionSegmentationData
/// The shape of every region, and the moments of the surface.
struct Region_shapes
{
  std::vector<Region_shape> regions; ///< by region
  Second_moments surface;            ///< the sum of those of the regions
  Double_3 origin{0, 0, 0}; ///< of moments: close to the surface, which avoids cancellation
  double unit = 1;          ///< of lengths in moments: `Surface::length_unit()`

  Region_shapes() = default;

  /// `cells`: of the surface, of which each region of the faces is a union
  Region_shapes(const Surface& mesh, const Patches& cells, const Partition& region_of)
    : regions(region_of.number_of_parts())
    , unit(mesh.length_unit())
  {
    // The variance of an equilateral triangle of area 1 along a direction in its plane: 1 / (6
    // sqrt(3)).
    constexpr double variance_of_triangle = 0.096225044864937627;
    if (mesh.number_of_faces() > 0)
      origin = mesh.centroid(0);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const double share = internal::inverse(mesh.area()) * cells[c].area,
                   variance = share * variance_of_triangle;
      const Double_3& normal = cells[c].normal;
      Region_shape& region = regions[region_of[cells[c].center]];
      region.area_vector = region.area_vector + share * normal;
      region.moments.add(share, (1 / unit) * (cells[c].centroid - origin));
      Symmetric_3& second = region.moments.second;
      second.xx += share * variance;
      second.yy += share * variance;
      second.zz += share * variance;
      second.add_square(-share * variance, normal);
    }
    for (const Region_shape& region : regions)
      surface.add(region.moments);
  }

  /// The centroid of moments, in the coordinates of the surface.
  Double_3 centroid(const Second_moments& moments) const
  {
    return origin + unit * moments.centroid();
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_REGION_SHAPES_H
