// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_INTRINSIC_FRAME_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_INTRINSIC_FRAME_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/internal/support/Second_moments.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A right-handed frame that moves with a surface, and a position of points along a direction that is generic in it: what is
/// ordered by positions does not depend on motion, scale and numbering.
///
/// The first axis is the first of two moments that does not vanish: the integrals of |x|^2 x and of (N . x) x, x the vector from
/// the centroid of the surface, N the normal. The second one is the part orthogonal to it of the first of these, of the integral of
/// |x|^2 N, and of the covariance applied to the first axis. Where all vanish, since the surface is symmetric, an axis leads to the
/// farthest face: of several those of one handedness, which the symmetry makes equivalent, then the lowest one.
class Intrinsic_frame
{
public:
  Intrinsic_frame() = default;

  /// `Faces`: `size()`, `area(i)`, `centroid(i)`, `normal(i)`
  template <typename Faces>
  explicit Intrinsic_frame(const Faces& faces)
  {
    if (faces.size() == 0)
      return;
    const double size = find_origin(faces);
    if (!(size > 0))
      return;
    const auto place = [&](std::size_t f) { return (1 / size) * (faces.centroid(f) - m_origin); };
    Double_3 by_distance{0, 0, 0}, by_height{0, 0, 0}, normals{0, 0, 0};
    Second_moments moments;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const Double_3 x = place(f);
      const double area = faces.area(f) / size / size, squared_distance = squared_norm(x);
      const Double_3 normal = faces.normal(f);
      by_distance = by_distance + area * squared_distance * x;
      by_height = by_height + area * dot(normal, x) * x;
      normals = normals + area * squared_distance * normal;
      moments.add(area, x);
    }
    const double least = smallest_part * moments.second.trace();
    const auto farthest = [&](const Double_3& axis) {
      std::tuple<double, double> largest{-1, 0};
      Double_3 result{1, 0, 0};
      for (std::size_t f = 0; f < faces.size(); ++f) {
        const Double_3 x = place(f), from_axis = x - dot(x, axis) * axis;
        const Double_3 other = squared_norm(axis) > 0 ? axis : moments.second * x;
        const std::tuple<double, double> value{std::floor(steps * squared_norm(from_axis)),
                                               std::floor(steps * dot(cross(other, x), faces.normal(f)))};
        if (value > largest) {
          largest = value;
          result = from_axis;
        }
      }
      return result;
    };
    const auto first_of = [&](const Double_3& axis, std::initializer_list<Double_3> moments_) {
      for (const Double_3& m : moments_)
        if (const Double_3 part = m - dot(m, axis) * axis; norm(part) > least)
          return part;
      return farthest(axis);
    };
    const auto unit = [](const Double_3& v) { return (1 / norm(v)) * v; };
    const Double_3 none{0, 0, 0};
    const Double_3 x = unit(first_of(none, {by_distance, by_height}));
    Double_3 y = first_of(x, {by_distance, by_height, normals, moments.second * x});
    if (!(squared_norm(y) > 0)) // all on a line
      y = cross(x, std::abs(x.x) < 0.5 ? Double_3{1, 0, 0} : Double_3{0, 1, 0});
    y = unit(y);
    m_axes = {x, y, cross(x, y)};
    m_direction = (1 / (4 * size)) * (m_axes[0] + 0.7548776662466927 * m_axes[1] + 0.5698402909980532 * m_axes[2]);
  }

  /// The coordinates of a vector.
  Double_3 operator()(const Double_3& v) const { return {dot(v, m_axes[0]), dot(v, m_axes[1]), dot(v, m_axes[2])}; }

  /// Of a point of the surface, in (0, 1).
  double position(const Double_3& point) const { return 0.5 + dot(point - m_origin, m_direction); }

private:
  static constexpr double smallest_part = 1e-5; // of a moment that does not vanish
  static constexpr double steps = 1e6;          // what is farther by less is as far

  /// Returns the largest distance from it.
  template <typename Faces>
  double find_origin(const Faces& faces)
  {
    const Double_3 first = faces.centroid(0); // avoids cancellation far from the origin
    Double_3 sum{0, 0, 0};
    double area = 0, squared_size = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      sum = sum + faces.area(f) * (faces.centroid(f) - first);
      area += faces.area(f);
    }
    m_origin = first + (area > 0 ? 1 / area : 0) * sum;
    for (std::size_t f = 0; f < faces.size(); ++f)
      squared_size = (std::max)(squared_size, squared_norm(faces.centroid(f) - m_origin));
    return std::sqrt(squared_size);
  }

  Double_3 m_origin{0, 0, 0};
  std::array<Double_3, 3> m_axes{Double_3{1, 0, 0}, Double_3{0, 1, 0}, Double_3{0, 0, 1}};
  Double_3 m_direction{0, 0, 0}; // the direction of positions, divided by an upper bound of them
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_INTRINSIC_FRAME_H
