// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_AXIS_BOX_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_AXIS_BOX_H

#include <CGAL/Region_segmentation/Double_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// An axis-parallel box; empty by default. Coordinates are rounded, so boxes that overlap still do.
/// Those that are not numbers are ignored.
struct Axis_box
{
  using Coordinates = std::array<float, 3>;

  Coordinates low = all(std::numeric_limits<float>::infinity());
  Coordinates high = all(-std::numeric_limits<float>::infinity());

  static constexpr Coordinates all(float x) { return {x, x, x}; }

  void add_point(const Coordinates& p) { add(p, p); }
  void add(const Axis_box& b) { add(b.low, b.high); }
  void add(const Coordinates& other_low, const Coordinates& other_high)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], other_low[i]);
      high[i] = (std::max)(high[i], other_high[i]);
    }
  }
  float extent(std::size_t axis) const { return high[axis] - low[axis]; }
  float center(std::size_t axis) const { return low[axis] + extent(axis) / 2; }
  std::size_t longest_axis() const
  {
    const std::size_t axis = extent(1) > extent(0) ? 1 : 0;
    return extent(2) > extent(axis) ? 2 : axis;
  }
};

inline double squared_gap(const Axis_box& a, const Axis_box& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double gap = (std::max)({a.low[i] - b.high[i], b.low[i] - a.high[i], 0.0f});
    sum += gap * gap;
  }
  return sum;
}

inline double squared_distance_of_centers(const Axis_box& a, const Axis_box& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double difference = b.center(i) - a.center(i);
    sum += difference * difference;
  }
  return sum;
}

/// Of an array of points.
template <typename Points>
Axis_box box_of(const Points& points)
{
  Axis_box result;
  for (const Double_3& p : points)
    result.add_point({float(p.x), float(p.y), float(p.z)});
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_AXIS_BOX_H
