// SPDX-License-Identifier: GPL-3.0-or-later

#include "soup/merge_equal_points.h"

#include <algorithm>
#include <numeric>

namespace segment_mesh {

void merge_equal_points(Polygon_soup& soup)
{
  std::vector<Point>& points = soup.points;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&points](std::size_t i, std::size_t j) {
    return points[i] < points[j] || (!(points[j] < points[i]) && i < j);
  });

  std::vector<std::size_t> first(points.size()); // the first point at the place of each
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && points[order[k]] == points[order[k - 1]] ? first[order[k - 1]]
                                                                        : order[k];

  std::vector<std::size_t>& new_index = order;
  std::size_t size = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (first[i] == i) {
      new_index[i] = size;
      points[size++] = points[i];
    } else
      new_index[i] = new_index[first[i]];
  }
  points.resize(size);
  soup.polygons.renumber([&](std::size_t i) { return new_index[i]; });
}

} // namespace segment_mesh
