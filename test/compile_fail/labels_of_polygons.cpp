// SPDX-License-Identifier: GPL-3.0-or-later
// expect: labels of polygons are a range or a property map of an integral type other than bool
#include "common.h"
#include <array>
#include <vector>
void test(const std::vector<std::array<double, 3>>& points,
          const std::vector<std::vector<std::size_t>>& polygons)
{
#ifdef WITH_FAULT
  std::vector<bool> labels(polygons.size());
#else
  std::vector<int> labels(polygons.size());
#endif
  RS::segment_polygon_soup(points, polygons, labels);
}
