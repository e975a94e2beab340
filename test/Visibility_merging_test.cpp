// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Evaluation/evaluation.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/segment.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace Visibility_merging_test {

Labels segment_into(const Soup& soup, std::size_t k)
{
  return segments_of(to_surface_mesh(soup),
                     RS::parameters::number_of_segments(k).method(RS::Visibility_merging()));
}

Labels segment_automatically(const Soup& soup)
{
  Surface_mesh mesh = to_surface_mesh(soup);
  auto map = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:segment").first;
  const std::size_t n = RS::segment(mesh, map, RS::parameters::method(RS::Visibility_merging()));
  const Labels labels = labels_of(mesh, map);
  EXPECT_TRUE(is_numbered_by_first_face(labels, n));
  return labels;
}

std::size_t number_of(const Labels& labels)
{
  return 1 + *std::max_element(labels.begin(), labels.end());
}

/// Four balls in a row that overlap a little: three round necks. `levels` sets the number of faces.
Soup caterpillar(std::size_t levels, std::vector<std::size_t>& truth)
{
  // Each point of a sphere goes to the place where its ray leaves the union, along x.
  Soup soup = sphere(levels);
  const double half_length = 3.4;
  for (Point& p : soup.points) {
    const double x = half_length * std::asin(p[0]) / std::asin(1.0);
    const double away = std::hypot(p[1], p[2]);
    double radius = 0;
    for (double center : {-2.55, -0.85, 0.85, 2.55})
      radius = std::max(radius,
                        std::sqrt(std::max(0.0, 0.85 * 0.85 * 1.1 - (x - center) * (x - center))));
    radius = std::max(radius, 0.02);
    p = {x, away > 0 ? radius * p[1] / away : 0, away > 0 ? radius * p[2] / away : 0};
  }
  truth.clear();
  for (const Polygon& polygon : soup.polygons) {
    double x = 0;
    for (std::size_t v : polygon)
      x += soup.points[v][0] / double(polygon.size());
    truth.push_back(x < -1.7 ? 0 : x < 0 ? 1 : x < 1.7 ? 2 : 3);
  }
  return soup;
}

TEST(Visibility_merging_test, finds_the_balls_of_a_caterpillar_at_any_resolution)
{
  for (std::size_t levels : {3, 4, 5}) {
    SCOPED_TRACE(levels);
    Labels truth;
    const Soup soup = caterpillar(levels, truth);
    // The coarsest one has hardly more faces than there are superfacets.
    EXPECT_LT(RS::rand_index_distance(segment_into(soup, 4), truth), levels == 3 ? 0.08 : 0.06);
  }
}

TEST(Visibility_merging_test, has_as_many_superfacets_as_are_wanted)
{
  const Soup soup = sphere(4); // 2,048 faces
  for (std::size_t k : {700, 800, 801, 1000, 2000, 2048}) {
    const Labels labels = segment_into(soup, k);
    EXPECT_EQ(number_of(labels), k);
    EXPECT_TRUE(is_connected(soup, labels));
  }
}

TEST(Visibility_merging_test, chooses_the_number_of_balls)
{
  Labels truth;
  const Soup soup = caterpillar(5, truth);
  EXPECT_EQ(number_of(segment_automatically(soup)), 4u);
}

TEST(Visibility_merging_test, gives_something_sensible_where_there_is_nothing)
{
  EXPECT_EQ(number_of(segment_automatically(sphere(3))), 1u);
  EXPECT_EQ(number_of(segment_automatically(joined(sphere(1), translated(sphere(1), 5, 0, 0)))),
            2u);
  Soup triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.polygons = {{0, 1, 2}};
  EXPECT_EQ(segment_automatically(triangle), Labels{0});
  Soup point = triangle; // all faces degenerate
  point.points = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(segment_automatically(point), Labels{0});
}

TEST(Visibility_merging_test, constants_are_members_of_its_parts)
{
  const Surface_mesh mesh = to_surface_mesh(random_mesh(Family::BLOCKS, 4));
  RS::Visibility_merging method;
  method.superfacets.number = 30;
  method.chooser.level = 1000; // above all costs: as few as possible
  const Result few = run(mesh, RS::parameters::method(method));
  EXPECT_LE(few.tree.number_of_regions(), 30u);
  EXPECT_GE(few.tree.number_of_regions(), 25u) << "few lose all of their elements to neighbors";
  EXPECT_EQ(few.number_of_segments, 2u);
  method.chooser.level = -1000;
  method.chooser.maximum_number = 7;
  EXPECT_EQ(run(mesh, RS::parameters::method(method)).number_of_segments, 7u);
}

TEST(Visibility_merging_test, other_constants_while_there_are_many_regions)
{
  // With the same constants for both, nothing depends on where they change.
  Labels truth;
  Soup soup = caterpillar(4, truth);
  std::mt19937 random(1);
  bump(soup, 0.01, random);
  const Surface_mesh mesh = to_surface_mesh(soup);
  const auto of_few = RS::Visibility_cost(), of_many = RS::Visibility_cost::for_many_regions();
  bool differ = false;
  for (std::size_t k : {5, 10, 20, 40, 80}) {
    const auto segments = [&](const RS::Visibility_cost& few, const RS::Visibility_cost& of_more,
                              std::size_t many) {
      return segments_of(mesh, RS::parameters::number_of_segments(k).method(
                                 RS::Visibility_merging(few, of_more, many)));
    };
    EXPECT_EQ(segments(of_few, of_few, 150), segments(of_few, of_many, 100000));
    EXPECT_EQ(segments(of_many, of_many, 150), segments(of_few, of_many, 1));
    differ = differ || segments(of_few, of_few, 150) != segments(of_many, of_many, 150);
  }
  EXPECT_TRUE(differ);
}

TEST(Number_from_costs_test, ends_where_merging_becomes_dear)
{
  RS::Merge_tree tree(6);
  for (std::uint32_t i = 5; i > 0; --i)
    tree.push_back({0, i, i == 1 ? -10.0 : i == 2 ? -14.0 : -30.0 + i});
  // Costs -25, -26, -27, -14, -10: the mean of -10 and -20 is -15, so merges at -14 and -10 are
  // left.
  EXPECT_EQ(RS::Number_from_costs(-20)(tree), 3u);
  EXPECT_EQ(RS::Number_from_costs(-1000)(tree), 6u);
  RS::Number_from_costs at_most_four(-1000);
  at_most_four.maximum_number = 4;
  EXPECT_EQ(at_most_four(tree), 4u);
  EXPECT_EQ(RS::Number_from_costs(1000)(tree), 2u);
  const double level = RS::Visibility_merging::default_level;
  EXPECT_EQ(RS::Number_from_costs(level)(RS::Merge_tree(1)), 1u);
  EXPECT_EQ(RS::Number_from_costs(level)(RS::Merge_tree(3)), 3u); // three pieces, nothing to merge
}

} // namespace Visibility_merging_test
