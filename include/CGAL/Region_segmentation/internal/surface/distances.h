// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_DISTANCES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_DISTANCES_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/internal/support/Function_ref.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Three corners; may be degenerate.
using Triangle = std::array<Double_3, 3>;

inline double in_unit_interval(double x)
{
  return (std::min)((std::max)(x, 0.0), 1.0);
}

/// From a point to a segment.
inline double squared_distance(const Double_3& p, const Double_3& a, const Double_3& b)
{
  const Double_3 along = b - a;
  const double squared_length = squared_norm(along);
  const double x = squared_length > 0 ? in_unit_interval(dot(p - a, along) / squared_length) : 0;
  return squared_norm(p - a - x * along);
}

/// Whether the projection of a point to the plane of a triangle with the given area vector is in
/// the triangle.
inline bool is_above(const Double_3& p, const Triangle& t, const Double_3& n)
{
  return dot(cross(t[1] - t[0], p - t[0]), n) >= 0 && dot(cross(t[2] - t[1], p - t[1]), n) >= 0 &&
         dot(cross(t[0] - t[2], p - t[2]), n) >= 0;
}

/// From a point to a triangle.
inline double squared_distance(const Double_3& p, const Triangle& t)
{
  const Double_3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double nn = squared_norm(n);
  if (nn > 0 && is_above(p, t, n)) {
    const double h = dot(p - t[0], n);
    return h / nn * h;
  }
  return (std::min)({squared_distance(p, t[0], t[1]), squared_distance(p, t[1], t[2]),
                     squared_distance(p, t[2], t[0])});
}

/// The x for which a + x (b - a) is the point of the segment a, b nearest to the segment c, d.
inline double nearest_parameter(const Double_3& a, const Double_3& b, const Double_3& c,
                                const Double_3& d)
{
  const Double_3 u = b - a, v = d - c, w = a - c;
  const double uu = squared_norm(u), uv = dot(u, v), vv = squared_norm(v), uw = dot(u, w),
               vw = dot(v, w);
  const double determinant = uu * vv - uv * uv;
  const double x = determinant > 1e-14 * uu * vv
                     ? in_unit_interval((uv * vw - vv * uw) / determinant)
                     : 0;
  const double y = vv > 0 ? (uv * x + vw) / vv : 0;
  if (y >= 0 && y <= 1)
    return x;
  return uu > 0 ? in_unit_interval((uv * in_unit_interval(y) - uw) / uu) : 0;
}

/// Whether an edge of `s` goes through `t`.
inline bool is_pierced(const Triangle& s, const Triangle& t)
{
  const Double_3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double h[3] = {dot(s[0] - t[0], n), dot(s[1] - t[0], n), dot(s[2] - t[0], n)};
  for (std::size_t i = 0; i < 3; ++i)
    if (const std::size_t j = (i + 1) % 3;
        (h[i] > 0) != (h[j] > 0) && is_above(s[i] + (h[i] / (h[i] - h[j])) * (s[j] - s[i]), t, n))
      return true;
  return false;
}

/// Between two triangles along the line through their centroids: at most their distance.
inline double squared_separation(const Triangle& s, const Triangle& t)
{
  const Double_3 along = (t[0] - s[0]) + (t[1] - s[1]) + (t[2] - s[2]);
  const auto position = [&](const Double_3& p) { return dot(along, p - s[0]); };
  const double gap = (std::min)({position(t[0]), position(t[1]), position(t[2])}) -
                     (std::max)({0.0, position(s[1]), position(s[2])});
  return gap > 0 ? gap / squared_norm(along) * gap : 0;
}

/// Between two triangles.
inline double squared_distance(const Triangle& s, const Triangle& t)
{
  if (is_pierced(s, t) || is_pierced(t, s))
    return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    least = (std::min)({least, squared_distance(s[i], t), squared_distance(t[i], s)});
    for (std::size_t j = 0; j < 3; ++j) {
      const Double_3 &a = s[i], &b = s[(i + 1) % 3], &c = t[j], &d = t[(j + 1) % 3];
      const double x = nearest_parameter(a, b, c, d);
      least = (std::min)(least, squared_distance(a + x * (b - a), c, d));
    }
  }
  return least;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_DISTANCES_H
