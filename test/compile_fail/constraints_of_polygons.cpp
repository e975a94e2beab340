// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the constraints of polygons are a range of pairs of indices of points
#include "common.h"
#ifdef WITH_FAULT
using Drawn = Mesh::Property_map<Mesh::Edge_index, bool>;
#else
using Drawn = std::vector<std::pair<int, int>>;
#endif
using Points = std::vector<CGAL::Simple_cartesian<double>::Point_3>;
void test(const Points& points, const std::vector<std::vector<int>>& polygons,
          std::vector<int>& labels, const Drawn& drawn)
{
  RS::segment_polygon_soup(points, polygons, labels, RS::parameters::constrained_edges(drawn));
}
