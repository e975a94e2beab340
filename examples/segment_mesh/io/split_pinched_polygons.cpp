// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/split_pinched_polygons.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace segment_mesh {

namespace {

using Polygon = std::vector<std::size_t>;

constexpr std::size_t none = std::size_t(-1);

void remove_equal_successors(Polygon& polygon)
{
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.back() == polygon.front())
    polygon.pop_back();
}

/// Splits one polygon at a time; the points have their places for all of them.
class Splitter
{
public:
  explicit Splitter(std::size_t number_of_points) : m_place(number_of_points, none) {}

  /// The pieces in the order in which they end along the polygon; one if it is not pinched.
  std::vector<Polygon> pieces(const Polygon& polygon)
  {
    std::vector<Polygon> result;
    Polygon open; // the corners since the last split, all different
    for (const std::size_t point : polygon) {
      if (m_place[point] != none) {
        const auto start = open.begin() + std::ptrdiff_t(m_place[point]);
        result.emplace_back(start, open.end());
        forget(result.back());
        open.erase(start, open.end());
      }
      m_place[point] = open.size();
      open.push_back(point);
    }
    forget(open);
    result.push_back(std::move(open));
    return result;
  }

private:
  void forget(const Polygon& polygon)
  {
    for (const std::size_t point : polygon)
      m_place[point] = none;
  }

  std::vector<std::size_t> m_place; ///< of each point among the open corners, or `none`
};

} // namespace

void split_pinched_polygons(std::size_t number_of_points, std::vector<Polygon>& polygons)
{
  Splitter splitter(number_of_points);
  std::vector<Polygon> others;
  for (Polygon& polygon : polygons) {
    remove_equal_successors(polygon);
    if (polygon.size() <= 3)
      continue;
    std::vector<Polygon> pieces = splitter.pieces(polygon);
    polygon = std::move(pieces.front());
    std::move(pieces.begin() + 1, pieces.end(), std::back_inserter(others));
  }
  std::move(others.begin(), others.end(), std::back_inserter(polygons));
}

} // namespace segment_mesh
