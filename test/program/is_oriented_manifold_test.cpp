// SPDX-License-Identifier: GPL-3.0-or-later

#include "soup/is_oriented_manifold.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace is_oriented_manifold_test {

using namespace segment_mesh;

/// Polygons whose corners may be changed.
struct Loose_soup
{
  Polygon_soup soup() const { return {std::vector<Point>(number_of_points), polygons}; }

  std::size_t number_of_points;
  std::vector<std::vector<std::size_t>> polygons;
};

/// An n x n grid of squares, each whole or as two triangles, rolled up at random.
Loose_soup random_grid(std::mt19937& random)
{
  const std::size_t n = 2 + random() % 3;
  const std::size_t columns = random() % 2 ? n : n + 1, rows = random() % 2 ? n : n + 1;
  const auto point = [=](std::size_t i, std::size_t j) {
    return i % columns + columns * (j % rows);
  };
  Loose_soup soup = {columns * rows, {}};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1),
                        d = point(i, j + 1);
      if (random() % 2)
        soup.polygons.push_back({a, b, c, d});
      else
        soup.polygons.insert(soup.polygons.end(), {{a, b, c}, {a, c, d}});
    }
  return soup;
}

/// Triangles around a point.
Loose_soup random_cone(std::mt19937& random)
{
  const std::size_t n = 3 + random() % (random() % 8 ? 20 : 100);
  Loose_soup soup = {n + 1, {}};
  for (std::size_t i = 0; i < n; ++i)
    soup.polygons.push_back({0, i + 1, (i + 1) % n + 1});
  return soup;
}

/// Drops a face, turns one, moves one of its corners, doubles it, or merges two points.
void damage(Loose_soup& soup, std::mt19937& random)
{
  std::vector<std::size_t>& face = soup.polygons[random() % soup.polygons.size()];
  const std::size_t p = random() % soup.number_of_points, q = random() % soup.number_of_points;
  switch (random() % 5) {
  case 0:
    if (soup.polygons.size() > 1)
      std::swap(face, soup.polygons.back()), soup.polygons.pop_back();
    break;
  case 1:
    std::reverse(face.begin(), face.end());
    break;
  case 2:
    face[random() % face.size()] = p;
    break;
  case 3:
    soup.polygons.push_back(std::vector<std::size_t>(face));
    break;
  default:
    for (std::vector<std::size_t>& polygon : soup.polygons)
      std::replace(polygon.begin(), polygon.end(), p, q);
  }
}

TEST(Is_oriented_manifold, says_what_cgal_says)
{
  const unsigned seed = std::random_device()();
  std::mt19937 random(seed);
  std::size_t count[2] = {0, 0};
  for (int round = 0; round < 4000; ++round) {
    Loose_soup soup = random() % 4 ? random_grid(random) : random_cone(random);
    for (std::size_t i = random() % 4; i > 0; --i)
      damage(soup, random);
    const bool expected = CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(
      soup.polygons);
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", round " << round);
    ASSERT_EQ(is_oriented_manifold(soup.soup()), expected);
    ++count[expected];
  }
  EXPECT_GT(count[false], 400u) << "seed " << seed;
  EXPECT_GT(count[true], 400u) << "seed " << seed;
}

TEST(Is_oriented_manifold, wants_three_corners)
{
  EXPECT_FALSE(is_oriented_manifold({std::vector<Point>(2), {{0, 1}}}));
}

} // namespace is_oriented_manifold_test
