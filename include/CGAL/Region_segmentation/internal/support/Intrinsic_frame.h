// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_INTRINSIC_FRAME_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_INTRINSIC_FRAME_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/internal/support/Second_moments.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A right-handed frame that moves with a surface, and the position of points along a direction that
/// is generic in it: an order by positions does not depend on motion, scale and numbering.
///
/// With x the vector from the centroid of the surface, N the normal and C the integral of x x^T, an
/// axis is the first of some integrals that does not vanish:
/// - the first axis a: |x|^2 x, (N . x) x;
/// - the second one: |x|^2 x, (N . x) x, |x|^2 N, C a, each the part orthogonal to a.
///
/// All of them vanish where the shape is symmetric. Then the axis leads to the face farthest from the
/// centroid, or from the first axis; of several to one with the largest (C x, x, N), or (a, x, N).
/// This triple product tells mirror images apart, so those that are left are equivalent, and the
/// lowest one will do.
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
    m_origin = centroid(faces);
    for (std::size_t f = 0; f < faces.size(); ++f)
      m_size = (std::max)(m_size, norm(faces.centroid(f) - m_origin));
    if (m_size > 0)
      set_axes(faces, moments(faces));
  }

  /// The coordinates of a vector.
  Double_3 operator()(const Double_3& v) const
  {
    return {dot(v, m_axes[0]), dot(v, m_axes[1]), dot(v, m_axes[2])};
  }

  /// Of a point of the surface, in (0, 1).
  double position(const Double_3& point) const { return 0.5 + dot(point - m_origin, m_direction); }

private:
  static constexpr double smallest_part = 1e-5; // of the trace of C: what is less vanishes
  static constexpr double steps = 1e6;          // what is farther by less is as far

  /// Integrals of x, in units of `m_size`, and of the normal.
  struct Moments
  {
    Double_3 by_distance{0, 0, 0}, by_height{0, 0, 0}, normals{0, 0, 0};
    Second_moments places;
  };

  template <typename Faces>
  static Double_3 centroid(const Faces& faces)
  {
    const Double_3 first = faces.centroid(0); // avoids cancellation far from the origin
    Double_3 sum{0, 0, 0};
    double area = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      sum = sum + faces.area(f) * (faces.centroid(f) - first);
      area += faces.area(f);
    }
    return first + (area > 0 ? 1 / area : 0) * sum;
  }

  template <typename Faces>
  Double_3 place(const Faces& faces, std::size_t f) const
  {
    return (1 / m_size) * (faces.centroid(f) - m_origin);
  }

  template <typename Faces>
  Moments moments(const Faces& faces) const
  {
    Moments m;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const Double_3 x = place(faces, f), normal = faces.normal(f);
      const double area = faces.area(f) / m_size / m_size;
      m.by_distance = m.by_distance + area * squared_norm(x) * x;
      m.by_height = m.by_height + area * dot(normal, x) * x;
      m.normals = m.normals + area * squared_norm(x) * normal;
      m.places.add(area, x);
    }
    return m;
  }

  template <typename Faces>
  void set_axes(const Faces& faces, const Moments& m)
  {
    const double least = smallest_part * m.places.second.trace();
    const auto axis_of = [&](const Double_3& axis, std::initializer_list<Double_3> integrals) {
      for (const Double_3& v : integrals)
        if (const Double_3 part = v - dot(v, axis) * axis; norm(part) > least)
          return (1 / norm(part)) * part;
      return farthest(faces, axis, m.places.second);
    };
    const Double_3 a = axis_of({0, 0, 0}, {m.by_distance, m.by_height});
    const Double_3 b = axis_of(a, {m.by_distance, m.by_height, m.normals, m.places.second * a});
    m_axes = {a, b, cross(a, b)};
    m_direction = (1 / (4 * m_size)) * (a + 0.7548776662466927 * b + 0.5698402909980532 * m_axes[2]);
  }

  /// The direction of the farthest face from an axis, or from the centroid if that is 0.
  template <typename Faces>
  Double_3 farthest(const Faces& faces, const Double_3& axis, const Symmetric_3& covariance) const
  {
    std::pair<double, double> largest{0, 0};
    Double_3 result{0, 0, 0};
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const Double_3 x = place(faces, f), away = x - dot(x, axis) * axis;
      const Double_3 other = squared_norm(axis) > 0 ? axis : covariance * x;
      const std::pair<double, double> value{std::floor(steps * squared_norm(away)),
                                            std::floor(steps * dot(cross(other, x), faces.normal(f)))};
      if (value.first > 0 && value > largest) {
        largest = value;
        result = away;
      }
    }
    if (squared_norm(result) == 0) // all on a line
      result = cross(axis, std::abs(axis.x) < 0.5 ? Double_3{1, 0, 0} : Double_3{0, 1, 0});
    return (1 / norm(result)) * result;
  }

  Double_3 m_origin{0, 0, 0};
  double m_size = 0; // the largest distance of a centroid from the origin
  std::array<Double_3, 3> m_axes{Double_3{1, 0, 0}, Double_3{0, 1, 0}, Double_3{0, 0, 1}};
  Double_3 m_direction{0, 0, 0}; // of positions, divided by an upper bound of them
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_INTRINSIC_FRAME_H
