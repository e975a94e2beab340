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
#include <type_traits>

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

TYPED_TEST(Number_choosers_test, convex_bodies_are_one_part)
{
  const auto number = [](const Soup& soup) { return chosen_number<TypeParam>(soup); };
  EXPECT_EQ(number(triangulated(block(1, 1, 1))), 1u);
  EXPECT_EQ(number(triangulated(block(8, 8, 8))), 1u);
  EXPECT_EQ(number(triangulated(block(3, 3, 20))), 1u);
  EXPECT_EQ(number(joined(triangulated(block(2, 2, 2)), translated(sphere(2), 9, 0, 0))), 2u)
    << "components";
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
  if constexpr (std::is_same_v<TypeParam, RS::Learned_merging>) {
    EXPECT_EQ(number(torus(24, 12)), 1u) << "nothing speaks for parts";
    EXPECT_EQ(number(triangulated(grid(4, 4))), 1u) << "a sheet";
    return;
  }
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
  const Surface_mesh mesh = to_surface_mesh(triangulated(random_mesh(Family::BLOCKS, 4)));
  const RS::Segmenter segmenter(mesh, RS::parameters::method(TypeParam()));
  const RS::Merge_tree& tree = segmenter.merge_tree();
  auto chooser = segmenter.method().chooser;
  EXPECT_EQ(chooser.minimum_number, (std::is_same_v<TypeParam, RS::Learned_merging> ? 1u : 2u));
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
  const auto number_with = [](const Surface_mesh& mesh, const std::set<Edge>& drawn, bool links) {
    const auto labels = face_map(mesh);
    const std::size_t n = RS::segment(mesh, labels,
                                      RS::parameters::method(TypeParam())
                                        .component_links(links)
                                        .edge_is_constrained_map(edge_map(mesh, drawn)));
    const Labels found = labels_of(mesh, labels);
    for (const auto& [edge, both] : faces_of_edges(soup_of(mesh)))
      EXPECT_TRUE(drawn.count(edge) == 0 || found[both[0]] != found[both[1]]);
    return n;
  };
  // Around the middle of the bar, where no border of the chosen segments is.
  const Surface_mesh bar = to_surface_mesh(triangulated(dumbbell()));
  const auto loop = edges_where(bar, [](const Kernel::Point_3& p) { return p.x() == 4; });
  ASSERT_EQ(loop.size(), 4u);
  const RS::Segmenter without(bar, RS::parameters::method(TypeParam())),
    with(bar, RS::parameters::method(TypeParam()).edge_is_constrained_map(edge_map(bar, loop)));
  EXPECT_EQ(number_with(bar, loop, true), with.number_of_segments())
    << "what is announced is what comes";
  EXPECT_GE(with.number_of_segments(), without.number_of_segments());

  // On a convex body, exactly one more; of two, also if they are linked.
  const auto equator_of_first = [](const Kernel::Point_3& p) {
    return std::abs(p.z()) < 1e-9 && p.x() < 2;
  };
  const Surface_mesh ball = to_surface_mesh(sphere(4)),
                     two = to_surface_mesh(joined(sphere(4), translated(sphere(4), 5, 0, 0)));
  for (const bool links : {false, true}) {
    EXPECT_EQ(number_with(ball, {}, links), 1u);
    EXPECT_EQ(number_with(ball, edges_where(ball, equator_of_first), links), 2u);
    EXPECT_EQ(number_with(two, edges_where(two, equator_of_first), links), 3u);
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
  auto map = face_map(mesh), seeds = face_map(mesh, std::size_t(-1));
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
