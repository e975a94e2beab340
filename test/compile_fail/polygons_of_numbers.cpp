// SPDX-License-Identifier: GPL-3.0-or-later
// expect: polygons are ranges of indices of points: of an integral type
#include "common.h"
#ifdef WITH_FAULT
using Index = double;
#else
using Index = int;
#endif
using Points = std::vector<CGAL::Simple_cartesian<double>::Point_3>;
void test(const Points& points, const std::vector<std::vector<Index>>& polygons,
          std::vector<int>& labels)
{
  RS::segment_polygon_soup(points, polygons, labels);
}
