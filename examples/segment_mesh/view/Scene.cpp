// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/Scene.h"

#include "soup/vector_algebra.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace segment_mesh {

namespace {

bool can_be_drawn(const Polygon_soup& soup, const Polygon_soup::Polygon& polygon)
{
  return polygon.size() >= 3 && std::all_of(polygon.begin(), polygon.end(), [&](std::size_t i) {
           return is_finite(soup.points[i]);
         });
}

void check(const Polygon_soup& soup, const std::vector<std::size_t>& labels)
{
  if (labels.size() != soup.polygons.size())
    throw std::invalid_argument(std::to_string(labels.size()) + " labels for " +
                                std::to_string(soup.polygons.size()) + " faces");
  for (const Polygon_soup::Polygon& polygon : soup.polygons)
    for (std::size_t i : polygon)
      if (i >= soup.points.size())
        throw std::invalid_argument("a face has a point that is not there");
}

void take_faces(const Polygon_soup& soup, const std::vector<std::size_t>& labels, Scene& scene)
{
  scene.is_used.resize(soup.points.size());
  scene.first_corners.push_back(0);
  for (std::size_t f = 0; f < labels.size(); ++f) {
    if (!can_be_drawn(soup, soup.polygons[f]))
      continue;
    for (std::size_t i : soup.polygons[f]) {
      scene.corners.push_back(Scene::Index(i));
      scene.is_used[i] = true;
    }
    scene.first_corners.push_back(Scene::Index(scene.corners.size()));
    scene.labels.push_back(labels[f]);
  }
}

/// Halves before adding: the sum of two coordinates could overflow.
void take_points(const Polygon_soup& soup, Scene& scene)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low = {infinity, infinity, infinity}, high = {-infinity, -infinity, -infinity};
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    for (std::size_t j = 0; scene.is_used[i] && j < 3; ++j) {
      low[j] = (std::min)(low[j], soup.points[i][j] / 2);
      high[j] = (std::max)(high[j], soup.points[i][j] / 2);
    }
  double extent = 0; // half the largest side of the box
  for (std::size_t j = 0; j < 3; ++j)
    extent = (std::max)(extent, high[j] - low[j]);

  scene.points.resize(soup.points.size());
  double radius = 0;
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    if (!scene.is_used[i])
      continue;
    for (std::size_t j = 0; j < 3 && extent > 0; ++j) // within 1, so that its square is finite
      scene.points[i][j] = (soup.points[i][j] / 2 - (low[j] / 2 + high[j] / 2)) / extent;
    radius = (std::max)(radius, inner_product(scene.points[i], scene.points[i]));
  }
  radius = std::sqrt(radius);
  for (Point& p : scene.points)
    p = radius > 0 ? times(1 / radius, p) : p;
}

/// By Newell's formula, relative to the first corner.
Point area_vector(const Scene& scene, std::size_t face)
{
  const Scene::Index first = scene.first_corners[face], end = scene.first_corners[face + 1];
  const Point& origin = scene.points[scene.corners[first]];
  Point sum = {0, 0, 0};
  for (Scene::Index c = first + 1; c + 1 < end; ++c)
    sum = plus(sum, cross_product(minus(scene.points[scene.corners[c]], origin),
                                  minus(scene.points[scene.corners[c + 1]], origin)));
  return sum;
}

} // namespace

Scene make_scene(const Polygon_soup& soup, const std::vector<std::size_t>& labels)
{
  check(soup, labels);
  Scene scene;
  take_faces(soup, labels, scene);
  take_points(soup, scene);
  for (std::size_t f = 0; f < scene.number_of_faces(); ++f)
    scene.area_vectors.push_back(area_vector(scene, f));
  return scene;
}

} // namespace segment_mesh
