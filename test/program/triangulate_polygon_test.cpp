// SPDX-License-Identifier: GPL-3.0-or-later

#include "soup/triangulate_polygon.h"

#include "soup/vector_algebra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace triangulate_polygon_test {

using namespace segment_mesh;

/// The triangles of a polygon whose corners are all points.
Triangles triangulate(const std::vector<Point>& points)
{
  Polygons polygons;
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < points.size(); ++i)
    corners.push_back(i);
  polygons.push_back(corners);
  Triangles triangles;
  triangulate_polygon(points, polygons[0], triangles);
  EXPECT_EQ(triangles.size(), points.size() - 2);
  return triangles;
}

double area_in_the_plane(const Point& a, const Point& b, const Point& c)
{
  return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

/// Triangles of a simple polygon in the plane z = 0 cover it once if none is turned and their areas
/// sum to its own.
void expect_cover(const std::vector<Point>& points)
{
  double expected = 0, sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    expected += area_in_the_plane({0, 0, 0}, points[i], points[(i + 1) % points.size()]);
  for (const auto& [a, b, c] : triangulate(points)) {
    const double area = area_in_the_plane(points[a], points[b], points[c]);
    EXPECT_GE(area, 0);
    sum += area;
  }
  EXPECT_NEAR(sum, expected, 1e-12 * expected);
}

/// Around the origin, in a ring of radii from 1 to 11 times the scale.
std::vector<Point> random_star(std::size_t n, double scale, std::mt19937& random)
{
  std::vector<Point> star;
  for (std::size_t j = 0; j < n; ++j) {
    const double radius = scale * (1 + double(random() % 1000) / 100),
                 angle = 2 * 3.14159265358979 * double(j) / double(n);
    star.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return star;
}

TEST(Triangulate_polygon, covers_concave_polygons)
{
  expect_cover({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  expect_cover({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}});
  expect_cover({{0, 0, 0},
                {4, 0, 0},
                {4, 3, 0},
                {3, 3, 0},
                {3, 1, 0},
                {2, 3, 0},
                {1, 1, 0},
                {1, 3, 0},
                {0, 3, 0}});
  std::mt19937 random(20240506);
  for (std::size_t i = 0; i < 100; ++i)
    expect_cover(random_star(4 + random() % 40, 1, random));
}

// A hole joined by a bridge: two corners are visited twice.
TEST(Triangulate_polygon, leaves_a_hole_open)
{
  expect_cover({{0, 0, 0},
                {4, 0, 0},
                {4, 4, 0},
                {0, 4, 0},
                {0, 0, 0},
                {1, 1, 0},
                {1, 3, 0},
                {3, 3, 0},
                {3, 1, 0},
                {1, 1, 0}});
  std::mt19937 random(20261128);
  for (std::size_t i = 0; i < 100; ++i) {
    const std::size_t n = 4 + random() % 40, bridge = random() % n;
    std::vector<Point> outside = random_star(n, 1, random), hole = random_star(n, 0.09, random);
    std::rotate(outside.begin(), outside.begin() + std::ptrdiff_t(bridge), outside.end());
    std::rotate(hole.begin(), hole.begin() + std::ptrdiff_t(bridge), hole.end());
    outside.push_back(outside.front());
    hole.push_back(hole.front());
    outside.insert(outside.end(), hole.rbegin(), hole.rend());
    expect_cover(outside);
  }
}

TEST(Triangulate_polygon, gives_triangles_of_any_polygon)
{
  triangulate({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});
  triangulate({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  std::vector<Point> circle;
  for (int i = 0; i < 3000; ++i)
    circle.push_back({std::cos(i * 0.002), std::sin(i * 0.002), 0});
  triangulate(circle);
}

} // namespace triangulate_polygon_test
