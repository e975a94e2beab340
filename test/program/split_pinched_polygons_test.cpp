// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/split_pinched_polygons.h"

#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <random>

namespace split_pinched_polygons_test {

using namespace segment_mesh;

using Polygon = std::vector<std::size_t>;
using Polygons = std::vector<Polygon>;

TEST(Split_pinched_polygons, splits_where_a_point_comes_again)
{
  Polygons polygons = {{0, 0, 1, 2, 2, 0}, {0, 1, 2, 0, 3, 4, 3, 5}, {5, 4, 3, 2}};
  split_pinched_polygons(6, polygons);
  EXPECT_EQ(polygons, (Polygons{{0, 1, 2}, {0, 1, 2}, {5, 4, 3, 2}, {3, 4}, {0, 3, 5}}));
}

/// What the two steps of CGAL's repair make of one polygon.
Polygons split_by_cgal(std::size_t number_of_points, const Polygon& polygon)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  std::vector<Kernel::Point_3> points;
  for (std::size_t i = 0; i < number_of_points; ++i)
    points.emplace_back(double(i), 0, 0);
  Polygons polygons = {polygon};
  using CGAL::Polygon_mesh_processing::internal::simplify_polygons_in_polygon_soup;
  using CGAL::Polygon_mesh_processing::internal::split_pinched_polygons_in_polygon_soup;
  simplify_polygons_in_polygon_soup<Kernel>(points, polygons);
  split_pinched_polygons_in_polygon_soup<Kernel>(points, polygons);
  return polygons;
}

TEST(Split_pinched_polygons, gives_the_pieces_that_cgal_gives)
{
  const unsigned seed = std::random_device()();
  std::mt19937 random(seed);
  for (int i = 0; i < 2000; ++i) {
    const std::size_t number_of_points = 3 + random() % 20;
    Polygon polygon(4 + random() % 40);
    for (std::size_t& point : polygon)
      point = random() % number_of_points;
    Polygons polygons = {polygon}, expected = split_by_cgal(number_of_points, polygon);
    split_pinched_polygons(number_of_points, polygons);
    ASSERT_EQ(polygons, expected) << "seed " << seed;
  }
}

} // namespace split_pinched_polygons_test
