// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points and polygons, as many programs store meshes: every triangle has points of its own, three
// of them meet at some edges, and a part is apart. No mesh type is needed, and k counts parts, not
// components.

#include <CGAL/region_segmentation.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <utility>
#include <vector>

using Point = std::array<double, 3>; // or a point of a kernel of CGAL
namespace RS = CGAL::Region_segmentation;

struct Soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;

  void add(const std::vector<Point>& corners)
  {
    polygons.emplace_back();
    for (const Point& p : corners) {
      polygons.back().push_back(points.size());
      points.push_back(p);
    }
  }

  /// The six sides of a box, each in n x n squares.
  void add_box(const Point& low, const Point& size, int n)
  {
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side)
        for (int i = 0; i < n * n; ++i) {
          std::vector<Point> corners;
          for (const auto& [u, v] :
               {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
            Point p = low;
            p[axis] += side * size[axis];
            p[(axis + 1) % 3] += (i % n + u) * size[(axis + 1) % 3] / n;
            p[(axis + 2) % 3] += (i / n + v) * size[(axis + 2) % 3] / n;
            corners.push_back(p);
          }
          add(corners); // oriented as it comes
        }
  }
};

int main()
{
  Soup soup;
  soup.add_box({0, 0, 0}, {4, 4, 4}, 16);    // a block,
  soup.add_box({1, 1, 4}, {2, 2, 6}, 16);    // a post on it: their surfaces touch,
  soup.add_box({1, 1, 10.1}, {2, 2, 2}, 16); // and a cap just above that

  std::vector<int> labels(soup.polygons.size());
  for (std::size_t k : {1, 2, 3})
    std::cout << RS::segment_polygon_soup(soup.points, soup.polygons, labels,
                                          RS::parameters::number_of_segments(k))
              << " segments\n";

  std::vector<std::size_t> sizes(3);
  for (int label : labels)
    ++sizes[std::size_t(label)];
  std::cout << sizes[0] << ", " << sizes[1] << " and " << sizes[2] << " polygons\n";

  // Components are kept apart on demand.
  const auto apart = RS::parameters::number_of_segments(1).component_links(false);
  std::cout << RS::segment_polygon_soup(soup.points, soup.polygons, labels, apart)
            << " components\n";
}
