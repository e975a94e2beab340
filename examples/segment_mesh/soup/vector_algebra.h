// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_VECTOR_ALGEBRA_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_VECTOR_ALGEBRA_H

#include "soup/Polygon_soup.h"

#include <cmath>
#include <vector>

namespace segment_mesh {

/// \name The little that drawing needs of vectors, without a kernel
/// @{
inline Point plus(const Point& v, const Point& w)
{
  return {v[0] + w[0], v[1] + w[1], v[2] + w[2]};
}

inline Point minus(const Point& v, const Point& w)
{
  return {v[0] - w[0], v[1] - w[1], v[2] - w[2]};
}

inline Point times(double factor, const Point& v)
{
  return {factor * v[0], factor * v[1], factor * v[2]};
}

inline double inner_product(const Point& v, const Point& w)
{
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

inline Point cross_product(const Point& v, const Point& w)
{
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}

inline double length(const Point& v)
{
  return std::sqrt(inner_product(v, v));
}

/// The zero vector for the zero vector.
inline Point unit_vector(const Point& v)
{
  const double size = length(v);
  return size > 0 ? times(1 / size, v) : Point{0, 0, 0};
}

/// The normal of a polygon, whose corners are indices of points, twice as long as its area is
/// large, by Newell's formula.
template <typename Polygon>
Point area_vector(const std::vector<Point>& points, const Polygon& polygon)
{
  const Point& origin = points[polygon[0]];
  Point sum = {0, 0, 0};
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum = plus(
      sum, cross_product(minus(points[polygon[i]], origin), minus(points[polygon[i + 1]], origin)));
  return sum;
}

inline bool is_finite(const Point& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_VECTOR_ALGEBRA_H
