// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/Scene.h"

#include "soup/Edge_list.h"
#include "soup/vector_algebra.h"

#include <algorithm>
#include <limits>

namespace segment_mesh {

namespace {

/// Halves before adding: the sum of two coordinates could overflow.
void take_points(const std::vector<Point>& points, Scene& scene)
{
  Polygon_soup& soup = scene.soup;
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
  if (radius > 0) {
    scene.center = plus(low, high);
    scene.radius = 2 * extent * radius;
  }
}

/// For each point its neighbors across edges of faces with different labels.
std::vector<std::vector<std::size_t>> neighbors_on_borders(const Scene& scene)
{
  const auto edge = [](std::size_t a, std::size_t b) {
    return Vertex_pair{(std::min)(a, b), (std::max)(a, b)};
  };
  std::vector<std::vector<std::size_t>> neighbors(scene.soup.points.size());
  for (const auto& [a, b] : borders_of_labels(scene.soup, scene.labels, edge)) {
    neighbors[a].push_back(b);
    neighbors[b].push_back(a);
  }
  return neighbors;
}

/// The sum of the unit normals of the faces at each point, divided by their number.
std::vector<Point> mean_normals(const Polygon_soup& soup)
{
  std::vector<Point> result(soup.points.size());
  std::vector<std::size_t> number_of_faces(soup.points.size());
  for (const Polygon_soup::Polygon& polygon : soup.polygons) {
    const Point normal = unit_vector(area_vector(soup.points, polygon));
    for (const std::size_t i : polygon) {
      result[i] = plus(result[i], normal);
      ++number_of_faces[i];
    }
  }
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = times(1 / (std::max)(1.0, double(number_of_faces[i])), result[i]);
  return result;
}

} // namespace

void smooth_borders(Scene& scene)
{
  constexpr std::size_t number_of_steps = 3;
  constexpr double least_length = 0.9; // of the mean of unit normals where the surface is smooth
  std::vector<Point>& points = scene.soup.points;
  const auto neighbors = neighbors_on_borders(scene);
  const std::vector<Point> normals = mean_normals(scene.soup);
  for (std::size_t step = 0; step < number_of_steps; ++step) {
    const std::vector<Point> before = points;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (neighbors[i].size() == 2 && length(normals[i]) > least_length) {
        const Point normal = unit_vector(normals[i]),
                    middle = times(0.5, plus(before[neighbors[i][0]], before[neighbors[i][1]])),
                    way = times(0.5, minus(middle, before[i]));
        points[i] = plus(before[i], minus(way, times(inner_product(way, normal), normal)));
      }
  }
}

Scene make_scene(const Polygon_soup& soup, const std::vector<std::size_t>& labels)
{
  Scene scene;
  scene.soup.polygons = soup.polygons;
  scene.labels = labels;
  take_points(soup.points, scene);
  return scene;
}

} // namespace segment_mesh
