// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_REGION_SHAPES_H
#define CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_REGION_SHAPES_H

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

/// 1 / area; 0 if the area is so small that this would be infinite.
inline double inverse(double area)
{
  return area >= (std::numeric_limits<double>::min)() ? 1 / area : 0;
}

/// The shape of a region: the sums of `Learned_annotator`; zero for a surface without area.
struct Region_shape
{
  Double_3 area_vector{0, 0, 0};
  Second_moments moments;

  /// Of length 1, or zero.
  Double_3 normal() const
  {
    const double length = norm(area_vector);
    return length > 0 ? (1 / length) * area_vector : Double_3{0, 0, 0};
  }
};

/// The shape of every region, and the moments of the surface.
struct Region_shapes
{
  std::vector<Region_shape> regions;
  Second_moments surface;
  Double_3 origin{0, 0, 0}; // of moments: close to the surface, which avoids cancellation
  double unit = 1;          // of lengths

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
      const double share = inverse(mesh.area()) * cells[c].area,
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

/// The largest share that concave edges have in the sum of length times deviation of a convex
/// surface: rounding, and quads that are divided along the wrong diagonal. Independent of the
/// resolution, as a bound on angles would not be.
constexpr double largest_concave_share_of_convex = 1e-3;
/// The largest sum of the area vectors of a closed surface, relative to that of the areas.
constexpr double largest_gap_of_closed = 1e-6;

inline bool counts_for_convexity(const Surface& mesh, std::size_t edge)
{
  return mesh.has_flag(edge, Surface::CONCAVE | Surface::CONVEX) &&
         !mesh.is_crumb(mesh.lower_face(edge));
}

/// Whether concave edges surely have more than `largest_concave_share_of_convex`. Angles are
/// expensive; so they are bounded: an angle is at least the distance of the unit normals, at most
/// pi / 2 times this distance, and at most pi. Half of the edges of a fine mesh are sufficient for
/// that. The result is false for each convex surface.
inline bool is_clearly_concave(const Surface& mesh)
{
  double squared_lengths = 0; // of the edges that are not known yet
  for (std::size_t e = 0; e < mesh.number_of_adjacencies(); ++e)
    squared_lengths += mesh.squared_length(e);
  squared_lengths *= 1 + 1e-6; // rounding
  const std::size_t n = mesh.number_of_adjacencies();
  double concave = 0, convex = 0;
  const auto is_exceeded = [&](std::size_t known) {
    // the length of the others is bounded by Cauchy's inequality
    const double length = std::sqrt(double(n - known) * (std::max)(squared_lengths, 0.0));
    return concave >
           largest_concave_share_of_convex * (CGAL_PI / 2 * (concave + convex) + CGAL_PI * length);
  };
  for (std::size_t e = 0; e < n; ++e) {
    squared_lengths -= mesh.squared_length(e);
    if (counts_for_convexity(mesh, e)) {
      const Double_3 between = mesh.normal(mesh.lower_face(e)) - mesh.normal(mesh.higher_face(e));
      const double product = std::sqrt(mesh.squared_length(e) * squared_norm(between));
      (mesh.has_flag(e, Surface::CONCAVE) ? concave : convex) += product;
    }
    if (e % 256 == 255 && is_exceeded(e + 1))
      return true;
  }
  return is_exceeded(n);
}

/// Whether all components of a surface but crumbs bound convex bodies: the surface is closed, and
/// has no concave edges. (A closed surface that is convex at all edges is convex: van Heijenoort
/// 1952.) The result is false for a surface without area. O(F).
inline bool is_convex(const Surface& mesh)
{
  if (mesh.area() == 0 || is_clearly_concave(mesh))
    return false;
  Double_3 sum = {0, 0, 0};
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    sum = sum + mesh.weight(f) * mesh.normal(f);
  if (!(norm(sum) <= largest_gap_of_closed * mesh.area()))
    return false;
  double concave = 0, convex = 0;
  for (std::size_t e = 0; e < mesh.number_of_adjacencies(); ++e)
    if (counts_for_convexity(mesh, e))
      (mesh.has_flag(e, Surface::CONCAVE) ? concave : convex) += mesh.length(e) * mesh.deviation(e);
  return concave <= largest_concave_share_of_convex * (concave + convex);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_REGION_SHAPES_H
