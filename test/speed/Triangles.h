// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_SPEED_TRIANGLES_H
#define CGAL_REGION_SEGMENTATION_TEST_SPEED_TRIANGLES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace speed_benchmark {

/// What every mesh type is made from; flat, since there are up to a hundred million of them.
struct Triangles
{
  using Point = std::array<double, 3>;
  using Corners = std::array<std::uint32_t, 3>;

  std::vector<Point> points;
  std::vector<Corners> corners;
};

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_SPEED_TRIANGLES_H
