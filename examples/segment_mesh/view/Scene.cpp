// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/Scene.h"

#include "soup/vector_algebra.h"

#include <algorithm>
#include <limits>

namespace segment_mesh {

namespace {

/// Halves before adding: the sum of two coordinates could overflow.
void take_points(const std::vector<Point>& points, Polygon_soup& soup)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Polygons::Index>& corners = soup.polygons.corners();
  Point low = {infinity, infinity, infinity}, high = {-infinity, -infinity, -infinity};
  for (const std::size_t i : corners)
    for (std::size_t j = 0; j < 3; ++j) {
      low[j] = (std::min)(low[j], points[i][j] / 2);
      high[j] = (std::max)(high[j], points[i][j] / 2);
    }
  const Point extents = minus(high, low); // half the sides of the box
  const double extent = *std::max_element(extents.begin(), extents.end());
  soup.points.resize(points.size());
  double radius = 0;
  for (const std::size_t i : corners) {
    for (std::size_t j = 0; j < 3 && extent > 0; ++j) // within 1, so that its square is finite
      soup.points[i][j] = (points[i][j] / 2 - (low[j] / 2 + high[j] / 2)) / extent;
    radius = (std::max)(radius, length(soup.points[i]));
  }
  for (Point& p : soup.points)
    p = radius > 0 ? times(1 / radius, p) : p;
}

} // namespace

Scene make_scene(const Polygon_soup& soup, const std::vector<std::size_t>& labels)
{
  Scene scene;
  for (std::size_t f = 0; f < labels.size(); ++f) {
    const Polygon_soup::Polygon polygon = soup.polygons[f];
    if (polygon.size() < 3 || !std::all_of(polygon.begin(), polygon.end(), [&](std::size_t i) {
          return is_finite(soup.points[i]);
        }))
      continue;
    scene.soup.polygons.push_back(polygon);
    scene.labels.push_back(labels[f]);
  }
  take_points(soup.points, scene.soup);
  return scene;
}

} // namespace segment_mesh
