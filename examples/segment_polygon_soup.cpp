// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points and polygons, as many programs store meshes: no mesh type is needed, and k counts parts,
// not components.

#include <CGAL/region_segmentation.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <vector>

using Point = std::array<double, 3>; // or a point of a kernel of CGAL
namespace RS = CGAL::Region_segmentation;

struct Soup
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 4>> polygons;

  /// The six sides of a box, each in n x n squares that have points of their own.
  void add_box(const Point& low, const Point& size, int n)
  {
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side)
        for (int i = 0; i < n * n; ++i) {
          const std::size_t p = points.size();
          polygons.push_back({p, p + 1, p + 3, p + 2}); // oriented as it comes
          for (int corner = 0; corner < 4; ++corner) {
            points.push_back(low);
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            points.back()[axis] += side * size[axis];
            points.back()[u] += (i % n + corner % 2) * size[u] / n;
            points.back()[v] += (i / n + corner / 2) * size[v] / n;
          }
        }
  }
};

int main()
{
  Soup soup;
  soup.add_box({0, 0, 0}, {4, 4, 4}, 16);    // a block,
  soup.add_box({1, 1, 4}, {2, 2, 6}, 16);    // a post on it: their surfaces touch,
  soup.add_box({1, 1, 10.1}, {2, 2, 2}, 16); // and a cap just above that

  std::vector<std::size_t> labels(soup.polygons.size());
  for (std::size_t k : {1, 2, 3})
    std::cout << RS::segment_polygon_soup(soup.points, soup.polygons, labels,
                                          RS::parameters::number_of_segments(k))
              << " segments\n";

  const char* const colors[] = {" 230 80 80\n", " 80 200 80\n", " 80 80 230\n"};
  std::ofstream out("segment_polygon_soup.off");
  out << "OFF\n" << soup.points.size() << ' ' << soup.polygons.size() << " 0\n";
  for (const auto& [x, y, z] : soup.points)
    out << x << ' ' << y << ' ' << z << '\n';
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto& [a, b, c, d] = soup.polygons[i];
    out << "4 " << a << ' ' << b << ' ' << c << ' ' << d << colors[labels[i]];
  }
}
