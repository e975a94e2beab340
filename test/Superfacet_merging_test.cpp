// SPDX-License-Identifier: GPL-3.0-or-later

// What both methods on superfacets, `Learned_merging` and `Visibility_merging`, promise.

#include "meshes.h"
#include "oracles.h"
#include "superfacet_stages.h"

#include <CGAL/Region_segmentation/Evaluation/evaluation.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/segment.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace Superfacet_merging_test {

template <typename Method>
struct Superfacet_merging : ::testing::Test
{
  static Labels segment(const Soup& soup)
  {
    return segments_of(to_surface_mesh(soup), RS::parameters::method(Method()));
  }
  static Labels segment(const Soup& soup, std::size_t k)
  {
    return segments_of(to_surface_mesh(soup),
                       RS::parameters::number_of_segments(k).method(Method()));
  }
  static std::size_t chosen_number(const Soup& soup)
  {
    const Labels labels = segment(soup);
    return 1 + *std::max_element(labels.begin(), labels.end());
  }
};
using Methods = ::testing::Types<RS::Learned_merging, RS::Visibility_merging>;
TYPED_TEST_SUITE(Superfacet_merging, Methods);

TYPED_TEST(Superfacet_merging, each_segment_has_a_face_that_is_neither_degenerate_nor_doubled)
{
  Soup soup = triangulated(cube());
  soup.polygons.push_back(soup.polygons[3]); // doubled
  soup.polygons.push_back({soup.polygons[5][0], soup.polygons[5][2], soup.polygons[5][1]});
  soup.polygons.push_back({0, 1, 1}); // degenerate
  soup.polygons.push_back({2, 2, 2});
  constexpr std::size_t proper = 12;
  for (std::size_t k = 1; k <= 20; ++k) {
    const auto np = RS::parameters::number_of_segments(k).method(TypeParam());
    const RS::Polygon_soup_segmenter segmenter(soup.points, soup.polygons, np);
    std::vector<std::size_t> labels(soup.polygons.size()), again(labels.size());
    const std::size_t expected = std::min(k, proper);
    EXPECT_EQ(RS::segment_polygon_soup(soup.points, soup.polygons, labels, np), expected);
    EXPECT_EQ(segmenter.segment(again, k), expected);
    EXPECT_EQ(labels, again);
    EXPECT_EQ(std::set<std::size_t>(labels.begin(), labels.begin() + proper).size(), expected);
    EXPECT_EQ(labels[proper], labels[3]);
    EXPECT_EQ(labels[proper + 1], labels[5]);
  }
}

/// Gives as many segments as are asked for, for a list of numbers up to that of the proper faces.
template <typename Method>
void expect_every_number(const Soup& soup)
{
  const RS::Surface surface = RS::make_surface_of_polygon_soup(soup.points, soup.polygons);
  std::size_t proper = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    proper += !surface.is_degenerate(f);
  std::vector<std::size_t> labels(soup.polygons.size());
  for (std::size_t k : {std::size_t(1), proper / 9, proper / 4, proper / 3, proper / 2,
                        proper / 2 + 1, proper * 3 / 4, proper - 2, proper - 1, proper}) {
    SCOPED_TRACE(std::to_string(k) + " of " + std::to_string(proper));
    k = std::max<std::size_t>(k, 1);
    const auto np = RS::parameters::number_of_segments(k).method(Method());
    EXPECT_EQ(RS::segment_polygon_soup(soup.points, soup.polygons, labels, np), k);
    EXPECT_TRUE(is_numbered_by_first_face(labels, k));
    const RS::Polygon_soup_segmenter segmenter(soup.points, soup.polygons, np);
    std::vector<std::size_t> again(labels.size());
    EXPECT_EQ(segmenter.segment(again), k);
    EXPECT_EQ(again, labels);
  }
}

TYPED_TEST(Superfacet_merging, there_are_as_many_segments_as_are_asked_for)
{
  expect_every_number<TypeParam>(sphere(3));
  expect_every_number<TypeParam>(sphere(4));
}

TYPED_TEST(Superfacet_merging, there_are_as_many_segments_as_are_asked_for_where_patches_are_few)
{
  // Columns from 1 to 2^-25 wide: most faces are so small that patches have several.
  Soup soup = mapped(triangulated(grid(30, 12)), [](const Point& p) {
    return Point{std::exp2(-p[0] / 1.2), p[1] / 12, 0};
  });
  const RS::Surface surface = surface_of_soup(soup);
  ASSERT_LT(patches_of(surface).fine.size(), surface.number_of_faces() * 3 / 4);
  expect_every_number<TypeParam>(soup);
  expect_every_number<TypeParam>(
    joined(soup, translated(scaled(sphere(1), 1e-4), 2, 0, 0))); // a crumb
}

/// Whether each segment has a face that is not degenerate, for all numbers of segments.
template <typename Method>
void expect_proper_segments(const Soup& soup, const Method& method)
{
  const RS::Polygon_soup_segmenter segmenter(soup.points, soup.polygons,
                                             RS::parameters::method(method));
  for (std::size_t k = 2; k <= segmenter.regions().number_of_parts(); ++k) {
    Labels labels(soup.polygons.size());
    const std::size_t n = segmenter.segment(labels, k);
    std::set<std::size_t> proper;
    for (std::size_t f = 0; f < labels.size(); ++f)
      if (!segmenter.surface().is_degenerate(f))
        proper.insert(labels[f]);
    EXPECT_EQ(proper.size(), n) << k;
  }
}

TYPED_TEST(Superfacet_merging, no_segment_keeps_degenerate_faces_alone_when_borders_move)
{
  for (Family family : {Family::DEGENERATE_SHEET, Family::DEGENERATE_TORUS})
    for (unsigned seed = 1; seed <= 30; ++seed) { // 5, 15 and 28 had such segments
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      expect_proper_segments(random_mesh(family, seed), TypeParam());
    }
}

TYPED_TEST(Superfacet_merging, does_not_depend_on_the_numbering)
{
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    Soup soup = triangulated(seed % 2 == 0 ? sphere(4) : torus(40, 24));
    if (seed > 4) // other components
      soup = joined(joined(soup, translated(triangulated(torus(30, 20)), 3, 8, 0)),
                    translated(sphere(3), -4, 0, 1));
    for (Point& p : soup.points) // no two faces are alike
      for (double& x : p)
        x *= 1 + 0.05 * any(random);
    Soup other = soup;
    std::vector<std::size_t> order(soup.polygons.size()), new_vertex;
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t i = 0; i < order.size(); ++i) {
      other.polygons[order[i]] = soup.polygons[i];
      std::rotate(other.polygons[order[i]].begin(), other.polygons[order[i]].begin() + random() % 3,
                  other.polygons[order[i]].end());
    }
    shuffle_vertices(other, random, new_vertex);
    const auto expect_same = [&](const Labels& labels, const Labels& of_other) {
      Labels in_order(labels.size());
      for (std::size_t i = 0; i < order.size(); ++i)
        in_order[i] = of_other[order[i]];
      EXPECT_EQ(renumbered(in_order), labels);
    };
    expect_same(TestFixture::segment(soup, 7), TestFixture::segment(other, 7));
    expect_same(TestFixture::segment(soup, 200), TestFixture::segment(other, 200));
    expect_same(TestFixture::segment(soup), TestFixture::segment(other));
  }
}

/// Balls in a row that overlap a little, with round necks between them; `truth`: the ball of each
/// face, which is at one of the `centers`. `levels` sets the number of faces.
Soup balls(std::size_t levels, const std::vector<double>& centers, double half_length,
           double squared_radius, Labels& truth)
{
  // Each point of a sphere goes to the place where its ray leaves the union, along x.
  Soup soup = mapped(sphere(levels), [&](const Point& p) {
    const double x = half_length * std::asin(p[0]) / std::asin(1.0);
    const double away = std::hypot(p[1], p[2]);
    double radius = 0.02;
    for (double center : centers)
      radius = std::max(radius,
                        std::sqrt(std::max(0.0, squared_radius - (x - center) * (x - center))));
    return Point{x, away > 0 ? radius * p[1] / away : 0, away > 0 ? radius * p[2] / away : 0};
  });
  truth.clear();
  for (const Polygon& polygon : soup.polygons) {
    double x = 0;
    for (std::size_t v : polygon)
      x += soup.points[v][0] / double(polygon.size());
    const auto is_nearer = [&](double a, double b) { return std::abs(x - a) < std::abs(x - b); };
    truth.push_back(
      std::size_t(std::min_element(centers.begin(), centers.end(), is_nearer) - centers.begin()));
  }
  return soup;
}

Soup caterpillar(std::size_t levels, Labels& truth)
{
  return balls(levels, {-2.55, -0.85, 0.85, 2.55}, 3.4, 0.85 * 0.85 * 1.1, truth);
}

TYPED_TEST(Superfacet_merging, finds_the_balls_of_a_caterpillar_at_any_resolution)
{
  for (std::size_t levels : {3, 4, 5}) {
    SCOPED_TRACE(levels);
    Labels truth;
    const Soup soup = caterpillar(levels, truth);
    // The coarsest one has hardly more faces than there are superfacets.
    EXPECT_LT(RS::rand_index_distance(TestFixture::segment(soup, 4), truth),
              levels == 3 ? 0.08 : 0.06);
  }
}

TEST(Learned_merging_test, finds_two_balls_under_noise)
{
  Labels truth;
  const Soup soup = balls(5, {-0.85, 0.85}, 1.8, 0.9, truth);
  for (const double deviation : {0.007, 0.014}) // a quarter of the edges at most
    for (const unsigned seed : {1, 2, 3}) {
      SCOPED_TRACE(std::to_string(deviation) + ", seed " + std::to_string(seed));
      const Labels labels = Superfacet_merging<RS::Learned_merging>::segment(
        with_noise(soup, deviation, seed), 2);
      EXPECT_LT(RS::rand_index_distance(labels, truth), 0.06);
    }
}

TEST(Learned_merging_test, a_sheet_is_one_segment)
{
  const auto sheet = [](const std::function<Point(double, double)>& place) {
    return mapped(triangulated(grid(40, 30)),
                  [&](const Point& p) { return place(p[0] / 40, p[1] / 30); });
  };
  const double pi = std::acos(-1.0);
  const std::vector<Soup> sheets = {sheet([](double u, double v) {
                                      return Point{u, v, 0};
                                    }),
                                    sheet([](double u, double v) {
                                      return Point{8 * u, v, 0};
                                    }),
                                    sheet([&](double u, double v) { // a disc
                                      return Point{v * std::cos(6.2 * u), v * std::sin(6.2 * u), 0};
                                    }),
                                    sheet([&](double u, double v) { // half a pipe
                                      return Point{std::cos(pi * u), std::sin(pi * u), 3 * v};
                                    }),
                                    sheet([&](double u, double v) { // a hill
                                      return Point{u, v, 0.2 * std::sin(pi * u) * std::sin(pi * v)};
                                    })};
  for (const Soup& soup : sheets)
    for (const Soup& seen : {soup, reversed(soup)})
      EXPECT_EQ(Superfacet_merging<RS::Learned_merging>::chosen_number(seen), 1u)
        << &soup - sheets.data();
}

TEST(Visibility_merging_test, chooses_the_number_of_balls)
{
  Labels truth;
  const Soup soup = caterpillar(5, truth);
  EXPECT_EQ(Superfacet_merging<RS::Visibility_merging>::chosen_number(soup), 4u);
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

TEST(Number_from_costs_test, the_documented_level_gives_the_known_number)
{
  for (unsigned seed = 1; seed <= 50; ++seed) {
    std::mt19937 random(seed);
    RS::Merge_tree tree(60);
    double highest_of_all = RS::Merge_tree::least_cost;
    for (std::uint32_t n = 60; n > 1; --n) {
      const double cost = std::uniform_real_distribution<double>(-30, 5)(random);
      tree.push_back({0, n - 1, cost});
      if (n <= 40)
        highest_of_all = (std::max)(highest_of_all, cost);
    }
    double before = RS::Merge_tree::least_cost; // the highest cost of the merges from 40 regions on
    for (std::size_t k = 40; k > 1; --k) {
      const double cost = tree.merges()[60 - k].cost;
      if (before < cost && k < 40) {
        EXPECT_EQ(RS::Number_from_costs(before + cost - highest_of_all)(tree), k)
          << "seed " << seed;
      }
      before = (std::max)(before, cost);
    }
  }
}

} // namespace Superfacet_merging_test
