// SPDX-License-Identifier: GPL-3.0-or-later

// What choosers of the number have in common: their constants, convex bodies, drawn loops.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Graph/internal/is_convex.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

namespace number_choosers_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;

template <typename Method>
struct Number_choosers_test : ::testing::Test
{};
using Methods = ::testing::Types<RS::Learned_merging, RS::Visibility_merging>;
TYPED_TEST_SUITE(Number_choosers_test, Methods);

template <typename Method>
std::size_t chosen_number(const Soup& soup)
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  return RS::Segmenter(mesh, RS::parameters::method(Method())).number_of_segments();
}

Soup block(int nx, int ny, int nz)
{
  return triangulated(voxel_surface(voxel_block({0, 0, 0}, {nx, ny, nz})));
}

TYPED_TEST(Number_choosers_test, convex_bodies_are_one_part)
{
  const auto number = [](const Soup& soup) { return chosen_number<TypeParam>(soup); };
  EXPECT_EQ(number(block(1, 1, 1)), 1u);
  EXPECT_EQ(number(block(8, 8, 8)), 1u);
  EXPECT_EQ(number(block(3, 3, 20)), 1u);
  EXPECT_EQ(number(joined(block(2, 2, 2), translated(sphere(2), 9, 0, 0))), 2u) << "components";
  EXPECT_EQ(number(pillow()), 1u) << "closed, flat";
  for (std::size_t levels : {2, 4}) {
    EXPECT_EQ(number(sphere(levels)), 1u);
    EXPECT_EQ(number(mapped(sphere(levels),
                            [](const Point& p) {
                              return Point{3 * p[0], p[1], 0.2 * p[2]};
                            })),
              1u);
  }
}

TYPED_TEST(Number_choosers_test, other_bodies_are_divided)
{
  const auto number = [](const Soup& soup) { return chosen_number<TypeParam>(soup); };
  EXPECT_GE(number(triangulated(dumbbell())), 2u);
  EXPECT_GE(number(torus(24, 12)), 2u);
  EXPECT_GE(number(triangulated(grid(4, 4))), 2u) << "not closed";
  EXPECT_GE(number(triangulated(l_shape())), 2u) << "one concave edge";
  // A waist that no edge shows: deviations are below a degree.
  EXPECT_GE(number(mapped(sphere(6),
                          [](const Point& p) {
                            const double waist = 0.3 + p[0] * p[0];
                            return Point{4 * p[0], waist * p[1], waist * p[2]};
                          })),
            2u);
}

TYPED_TEST(Number_choosers_test, constants)
{
  std::mt19937 random(3);
  Soup soup = triangulated(random_mesh(Family::BLOCKS, 4));
  const Surface_mesh mesh = to_surface_mesh(soup);
  const RS::Segmenter segmenter(mesh, RS::parameters::method(TypeParam()));
  const RS::Merge_tree& tree = segmenter.merge_tree();
  auto chooser = segmenter.method().chooser;
  EXPECT_EQ(chooser.minimum_number, 2u);
  EXPECT_EQ(chooser.granularity, 1);
  std::size_t last = 0;
  for (double granularity : {1e-9, 0.1, 0.5, 1., 2., 10., 1e9}) {
    chooser.granularity = granularity;
    EXPECT_GE(chooser(tree), last) << granularity;
    last = chooser(tree);
  }
  EXPECT_GT(last, 2u);
  chooser.maximum_number = last - 1;
  EXPECT_EQ(chooser.largest_number(tree), last - 1);
  EXPECT_LE(chooser(tree), last - 1);
  chooser.maximum_number = 1000000;
  EXPECT_EQ(chooser.largest_number(tree), tree.number_of_regions());
  chooser.minimum_number = 7;
  chooser.granularity = 1e-9;
  EXPECT_GE(chooser(tree), 7u);
}

TYPED_TEST(Number_choosers_test, a_drawn_loop_adds_a_segment)
{
  // Around the middle of the bar, where no border of the chosen segments is.
  const Surface_mesh mesh = to_surface_mesh(triangulated(dumbbell()));
  const RS::Segmenter without(mesh, RS::parameters::method(TypeParam()));
  const auto on_loop = [&](auto v) { return mesh.point(v).x() == 4; };
  auto drawn = edge_map(mesh);
  std::size_t edges_of_loop = 0;
  for (auto e : edges(mesh)) {
    const bool is_drawn = on_loop(source(e, mesh)) && on_loop(target(e, mesh));
    put(drawn, e, is_drawn);
    edges_of_loop += is_drawn;
  }
  ASSERT_EQ(edges_of_loop, 4u);
  const RS::Segmenter with(mesh,
                           RS::parameters::method(TypeParam()).edge_is_constrained_map(drawn));
  auto map = face_map(mesh);
  const std::size_t n = with.segment(map);
  EXPECT_EQ(n, with.number_of_segments()) << "what is announced is what comes";
  EXPECT_GE(n, without.number_of_segments());
  for (auto e : edges(mesh))
    if (get(drawn, e)) {
      EXPECT_NE(get(map, mesh.face(halfedge(e, mesh))),
                get(map, mesh.face(opposite(halfedge(e, mesh), mesh))));
    }

  // On a convex body, exactly one more.
  const Surface_mesh ball = to_surface_mesh(sphere(4));
  auto equator = edge_map(ball);
  for (auto e : edges(ball))
    put(equator, e,
        std::abs(ball.point(source(e, ball)).z()) < 1e-9 &&
          std::abs(ball.point(target(e, ball)).z()) < 1e-9);
  auto halves = face_map(ball);
  EXPECT_EQ(RS::segment(ball, halves, RS::parameters::method(TypeParam())), 1u);
  EXPECT_EQ(
    RS::segment(ball, halves, RS::parameters::method(TypeParam()).edge_is_constrained_map(equator)),
    2u);

  // Of two, also if they are linked.
  const Surface_mesh two = to_surface_mesh(joined(sphere(4), translated(sphere(4), 5, 0, 0)));
  auto first = edge_map(two);
  for (auto e : edges(two))
    put(first, e,
        std::abs(two.point(source(e, two)).z()) < 1e-9 &&
          std::abs(two.point(target(e, two)).z()) < 1e-9 && two.point(source(e, two)).x() < 2);
  for (const bool links : {false, true}) {
    auto parts = face_map(two);
    EXPECT_EQ(
      RS::segment(
        two, parts,
        RS::parameters::method(TypeParam()).edge_is_constrained_map(first).component_links(links)),
      3u);
  }
}

/// Chooses 3, and counts how often.
struct Counting_chooser
{
  std::shared_ptr<int> calls = std::make_shared<int>(0);

  std::size_t operator()(const RS::Merge_tree&, const RS::Surface&) const
  {
    ++*calls;
    return 3;
  }
};

// The share of the concave edges, by the angles themselves.
double concave_share(const RS::Surface& surface)
{
  double concave = 0, all = 0;
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const double product = surface.length(a) * surface.deviation(a);
    concave += surface.has_flag(a, RS::Surface::CONCAVE) ? product : 0;
    all += product;
  }
  return concave / all;
}

TEST(Is_convex_test, a_thousandth_of_the_deviation_may_be_concave)
{
  std::size_t number_convex = 0, number_of_dents = 0;
  for (const std::size_t levels : {2, 4, 6})
    for (double depth = 1e-4; depth < 0.2; depth *= 1.2) {
      Soup dented = sphere(levels);
      for (double& x : dented.points[0])
        x *= 1 - depth;
      const Surface_mesh mesh = to_surface_mesh(dented);
      const RS::Surface surface = RS::make_surface(mesh);
      const bool is_convex = RS::internal::is_convex(surface);
      EXPECT_EQ(is_convex, concave_share(surface) <= 1e-3) << levels << ", " << depth;
      number_convex += is_convex;
      ++number_of_dents;
    }
  EXPECT_GT(number_convex, number_of_dents / 8);
  EXPECT_LT(number_convex, number_of_dents / 8 * 7);
}

TEST(Number_chooser_of_Segmenter, is_asked_once_for_each_draw_and_change)
{
  const Surface_mesh mesh = to_surface_mesh(sphere(2)); // which has one draw
  auto map = face_map(mesh);
  auto seeds = face_map(mesh);
  for (auto f : faces(mesh))
    put(seeds, f, std::size_t(-1));
  const Counting_chooser chooser;
  const RS::Visibility_merging visibility;
  const RS::Superfacet_merging method{visibility.annotator, visibility.policy, chooser};
  RS::Segmenter segmenter(mesh, RS::parameters::method(method));
  EXPECT_EQ(segmenter.segment(map), 3u);
  EXPECT_EQ(segmenter.segment(map), 3u);
  EXPECT_EQ(segmenter.number_of_segments(), 3u);
  EXPECT_EQ(*chooser.calls, 1);
  put(seeds, *faces(mesh).begin(), 0);
  segmenter.set_seeds(seeds);
  EXPECT_EQ(segmenter.segment(map), 3u);
  EXPECT_EQ(*chooser.calls, 2);
  EXPECT_EQ(RS::segment(mesh, map, RS::parameters::method(method)), 3u);
  EXPECT_EQ(*chooser.calls, 3);

  RS::Segmenter with_number(mesh, RS::parameters::method(method).number_of_segments(5));
  EXPECT_EQ(with_number.segment(map), 5u);
  with_number.set_seeds(seeds);
  EXPECT_EQ(with_number.segment(map), 5u);
  EXPECT_EQ(RS::segment(mesh, map, RS::parameters::number_of_segments(4).method(method)), 4u);
  EXPECT_EQ(*chooser.calls, 5) << "where a number is given, it compares draws alone";
}

} // namespace number_choosers_test
