// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_TRIANGLE_CONTACT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_TRIANGLE_CONTACT_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/internal/surface/distances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// How two triangles are in contact, and how much.
struct Triangle_contact
{
  enum Kind { TOUCHING, CROSSING, ALONG_EDGE };
  Kind kind;
  double amount; ///< the area of the overlap, the length of the intersection, the length of the
                 ///< part of the edge
};

/// A triangle that is not degenerate, with its plane.
struct Plane_triangle
{
  explicit Plane_triangle(const Triangle& t)
    : corners(t)
  {
    const Double_3 n = cross(t[1] - t[0], t[2] - t[0]);
    const double length = norm(n);
    area = length / 2;
    normal = length > 0 ? (1 / length) * n : Double_3{0, 0, 0};
  }

  double height(const Double_3& p) const { return dot(p - corners[0], normal); }

  Triangle corners;
  Double_3 normal;
  double area;
};

/// A convex polygon that is clipped: a triangle, with at most one corner more for each half-space.
struct Clipped_triangle
{
  explicit Clipped_triangle(const Triangle& t)
    : corners{t[0], t[1], t[2]}
  {}

  /// Keeps the part where (p - origin) . normal <= 0.
  void clip(const Double_3& origin, const Double_3& normal)
  {
    std::array<Double_3, 6> kept;
    std::size_t n = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const Double_3 &p = corners[i], &q = corners[(i + 1) % size];
      const double h = dot(p - origin, normal), g = dot(q - origin, normal);
      if (h <= 0 && n < kept.size())
        kept[n++] = p;
      if ((h < 0 && g > 0) || (h > 0 && g < 0))
        if (n < kept.size())
          kept[n++] = p + (h / (h - g)) * (q - p);
    }
    corners = kept;
    size = n;
  }

  double area() const
  {
    Double_3 sum{0, 0, 0};
    for (std::size_t i = 2; i < size; ++i)
      sum = sum + cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return norm(sum) / 2;
  }

  std::array<Double_3, 6> corners;
  std::size_t size = 3;
};

/// The area where two nearly parallel triangles lie on each other, seen along the normal of `s`; 0
/// if they come within the tolerance nowhere, or are further apart somewhere than it and a quarter
/// of their size.
inline double touching_area(const Plane_triangle& s, const Plane_triangle& t, double tolerance)
{
  const double cosine = dot(s.normal, t.normal);
  if (std::abs(cosine) < 0.9)
    return 0;
  Clipped_triangle overlap(s.corners);
  const double side = cosine > 0 ? 1 : -1;
  for (std::size_t i = 0; i < 3 && overlap.size > 2; ++i)
    overlap.clip(t.corners[i], cross(side * (t.corners[(i + 1) % 3] - t.corners[i]), s.normal));
  const double area = overlap.area(), size = std::sqrt((std::min)(s.area, t.area));
  if (!(area > 1e-9 * size * size))
    return 0;
  double lowest = t.height(overlap.corners[0]), highest = lowest;
  for (std::size_t i = 1; i < overlap.size; ++i) {
    const double h = t.height(overlap.corners[i]);
    lowest = (std::min)(lowest, h);
    highest = (std::max)(highest, h);
  }
  const double bound = (std::max)(tolerance, size / 4);
  const bool is_near = lowest <= tolerance && highest >= -tolerance;
  return is_near && highest <= bound && lowest >= -bound ? area : 0;
}

/// The length of the segment in which two triangles cross; 0 if a corner or edge of one only
/// touches the other.
inline double crossing_length(const Plane_triangle& s, const Plane_triangle& t, double tolerance)
{
  std::array<Double_3, 12> ends;
  std::size_t n = 0;
  for (const auto& [one, other] : {std::make_pair(&s, &t), std::make_pair(&t, &s)}) {
    bool above = false, below = false;
    for (const Double_3& p : one->corners) {
      above = above || other->height(p) > 1e-6 * tolerance;
      below = below || other->height(p) < -1e-6 * tolerance;
    }
    if (!above || !below)
      return 0;
    for_each_piercing(one->corners, other->corners, [&](const Double_3& p) { ends[n++] = p; });
  }
  double squared_length = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      squared_length = (std::max)(squared_length, squared_norm(ends[i] - ends[j]));
  return std::sqrt(squared_length);
}

/// An interval of a segment, as a range of [0, 1], that is clipped.
struct Clipped_segment
{
  double begin = 0, end = 1;

  /// Keeps the part where a value is at most 0 that is `at_begin` and `at_end` at the ends of the
  /// segment.
  void clip(double at_begin, double at_end)
  {
    if (at_begin > 0 && at_end > 0)
      end = begin;
    else if (at_begin > 0)
      begin = (std::max)(begin, at_begin / (at_begin - at_end));
    else if (at_end > 0)
      end = (std::min)(end, at_begin / (at_begin - at_end));
  }
};

/// The length of the part of the segment a, b within the tolerance of a triangle: of its plane, and
/// of its edges seen along the normal. 0 if it is shorter than `shortest`. `length`: of the segment
inline double length_near(const Double_3& a, const Double_3& b, const Plane_triangle& t,
                          double tolerance, double length, double shortest)
{
  Clipped_segment part;
  const double h = t.height(a), g = t.height(b);
  part.clip(h - tolerance, g - tolerance);
  part.clip(-h - tolerance, -g - tolerance);
  const auto length_left = [&] { return (part.end - part.begin) * length; };
  for (std::size_t i = 0; i < 3 && length_left() >= shortest; ++i) {
    const Double_3& p = t.corners[i];
    const Double_3 out = cross(t.corners[(i + 1) % 3] - p, t.normal);
    const double bound = tolerance * norm(out);
    part.clip(dot(a - p, out) - bound, dot(b - p, out) - bound);
  }
  return length_left() >= shortest ? length_left() : 0;
}

/// The length of the longest part of an edge of one triangle that lies on the other; parts shorter
/// than four times the tolerance and half of the edge, as where edges cross, do not count.
inline double length_along_edge(const Plane_triangle& s, const Plane_triangle& t, double tolerance)
{
  double longest = 0;
  for (const auto& [one, other] : {std::make_pair(&s, &t), std::make_pair(&t, &s)})
    for (std::size_t i = 0; i < 3; ++i) {
      const Double_3 &a = one->corners[i], &b = one->corners[(i + 1) % 3];
      const double length = norm(b - a), shortest = (std::min)(length / 2, 4 * tolerance);
      longest = (std::max)(longest, length_near(a, b, *other, tolerance, length, shortest));
    }
  return longest;
}

/// Whether all of a triangle is further from the plane of another one than the tolerance.
inline bool is_beside(const Plane_triangle& s, const Plane_triangle& t, double tolerance)
{
  const double h0 = t.height(s.corners[0]), h1 = t.height(s.corners[1]),
               h2 = t.height(s.corners[2]);
  return (std::min)({h0, h1, h2}) > tolerance || (std::max)({h0, h1, h2}) < -tolerance;
}

/// Calls `output(contact)` for the contact of two triangles. An overlap that may be a strip along
/// an edge, not wider than the tolerance, counts as both.
template <typename Output>
void find_contact(const Triangle& a, const Triangle& b, double tolerance, const Output& output)
{
  Plane_triangle s(a), t(b);
  if (s.area < t.area) // independently of their order
    std::swap(s, t);
  if (!(s.area > 0) || !(t.area > 0) || is_beside(s, t, tolerance) || is_beside(t, s, tolerance))
    return;
  const double smaller = t.area, size = std::sqrt(smaller);
  if (const double area = touching_area(s, t, tolerance); area > 0) {
    output(Triangle_contact{Triangle_contact::TOUCHING, area});
    if (area > (std::min)(tolerance * size, smaller / 10))
      return;
  } else if (const double length = crossing_length(s, t, tolerance); length > 0) {
    output(Triangle_contact{Triangle_contact::CROSSING, length});
    return;
  }
  if (const double length = length_along_edge(s, t, (std::min)(tolerance, size / 4)); length > 0)
    output(Triangle_contact{Triangle_contact::ALONG_EDGE, length});
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_TRIANGLE_CONTACT_H
