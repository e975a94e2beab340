// SPDX-License-Identifier: GPL-3.0-or-later

// The library against the reference implementation, which shares no code with it.

#include "meshes.h"
#include "oracles.h"
#include "reference_two_step.h"

#include <CGAL/Region_segmentation/segment.h>

#include <CGAL/iterator.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace reference_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;

struct Reference_test : ::testing::TestWithParam<Family>
{};

constexpr unsigned seeds_per_family = 60;

// The choice of the reference implementation, judged with a tolerance: two candidates within
// rounding of each other, as beside a flat cap, where one edge is as long as two others, are a tie
// that either implementation may break.
constexpr double rounding = 1e-9;

bool is_best_section(const reference::Region& region, std::size_t neighbor, double beta)
{
  const auto sum_of = [&](std::size_t i) {
    double sum = 0;
    for (const auto& [j, section] : region.sections)
      if (j != i)
        sum += beta * reference::share(region.sections.at(i).length, section.length) +
               (1 - beta) *
                 reference::share(region.sections.at(i).mean_angle(), section.mean_angle());
    return sum;
  };
  return std::abs(sum_of(reference::choose_neighbor(region, beta)) - sum_of(neighbor)) < rounding;
}

bool is_best_region(const reference::Regions& regions, std::size_t id, const Options& options)
{
  if (double(regions.size()) > options.factor * double(options.k)) {
    const double best = regions.at(reference::choose_smallest_region(regions)).area;
    return std::abs(regions.at(id).area - best) <= rounding * best;
  }
  const auto sum_of = [&](const reference::Region& i) {
    double sum = 0;
    for (const auto& entry : regions) {
      const reference::Region& j = entry.second;
      sum += options.gamma * reference::share_of_exponentials(i.planarity(), j.planarity()) +
             (1 - options.gamma) * reference::share(i.area, j.area);
    }
    return sum;
  };
  const std::size_t best = reference::choose_region_by_planarity(regions, options.gamma);
  return std::abs(sum_of(regions.at(best)) - sum_of(regions.at(id))) < rounding;
}

bool is_best_merge(const reference::Regions& regions, std::size_t a, std::size_t b,
                   const Options& options)
{
  const auto is_best = [&](std::size_t i, std::size_t j) {
    return regions.at(i).can_merge() && is_best_region(regions, i, options) &&
           is_best_section(regions.at(i), j, options.beta);
  };
  return !regions.at(a).sections.at(b).is_constrained && (is_best(a, b) || is_best(b, a));
}

/// Goes along both lists of merges up to the first difference, which must be a tie. Returns whether
/// there is one.
bool differs_by_a_tie(const Soup& soup, const Options& options,
                      const reference::Two_step_result& expected, const RS::Merge_tree& tree)
{
  const auto mesh = reference::read_mesh(soup.points, soup.polygons, options);
  auto regions = reference::build_regions(mesh, expected.region_id);
  EXPECT_EQ(tree.merges().size(), expected.merges.size());
  for (std::size_t i = 0; i < expected.merges.size(); ++i) {
    const auto merge = tree.merges().at(i);
    if (merge.kept != expected.merges[i].kept || merge.removed != expected.merges[i].removed) {
      EXPECT_TRUE(is_best_merge(regions, merge.kept, merge.removed, options))
        << "merge " << i << ": " << merge.kept << " " << merge.removed << ", not "
        << expected.merges[i].kept << " " << expected.merges[i].removed;
      return true;
    }
    reference::merge_regions(regions, merge.kept, merge.removed);
  }
  return false;
}

Options options_of(unsigned seed, const Soup& soup)
{
  std::mt19937 random(seed + 1000);
  Options options = random_options(random);
  if (random() % 2)
    options.constrained_edges = random_edges(soup, 15, random);
  if (random() % 3 == 0)
    options.minimum_length = 1 + random() % 4;
  return options;
}

TEST_P(Reference_test, gives_the_same_features_and_lines)
{
  for (unsigned seed = 0; seed < seeds_per_family; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Soup soup = random_mesh(GetParam(), seed);
    const Options options = options_of(seed, soup);
    const auto expected = reference::two_step(soup.points, soup.polygons, options);

    const Surface_mesh mesh = to_surface_mesh(soup);
    const auto constrained = edge_map(mesh, options.constrained_edges);
    auto is_feature = edge_map(mesh, std::uint8_t(1));
    const auto np = RS::parameters::component_links(false).edge_is_constrained_map(constrained);
    const std::size_t n = test::detect_feature_edges(mesh, is_feature, options.features(), np);
    ASSERT_EQ(flags_of(mesh, is_feature), expected.is_feature_detected);
    EXPECT_EQ(n, count(expected.is_feature_detected));

    test::extract_feature_lines(mesh, is_feature, CGAL::Emptyset_iterator(), options.minimum_length,
                                np);
    ASSERT_EQ(flags_of(mesh, is_feature), expected.is_feature_pruned);
  }
}

TEST_P(Reference_test, gives_the_same_regions_and_segments)
{
  std::size_t merges = 0, ties = 0;
  for (unsigned seed = 0; seed < seeds_per_family; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Soup soup = random_mesh(GetParam(), seed);
    Options options = options_of(seed, soup);
    if (seed % 2) {
      std::mt19937 random(seed);
      options.beta = double(random() % 11) / 10;
      options.gamma = double(random() % 11) / 10;
      options.factor = 1 + double(random() % 7) / 2;
    }
    for (std::size_t k : {options.k, std::size_t(1), std::size_t(25)}) {
      SCOPED_TRACE("k " + std::to_string(k));
      options.k = k;
      const auto expected = reference::two_step(soup.points, soup.polygons, options);
      const Result result = run(soup, options);
      ASSERT_EQ(result.regions, expected.region_id);
      ASSERT_EQ(result.features, expected.is_feature);
      ASSERT_EQ(result.number_of_segments, expected.number_of_segments);
      merges += expected.merges.size();
      if (differs_by_a_tie(soup, options, expected, result.tree))
        ++ties;
      else
        ASSERT_EQ(result.segments, expected.segment_id);
    }
  }
  EXPECT_GT(merges, 500u) << "too little was merged for the test to mean anything";
  EXPECT_LE(ties, has_degenerate_faces(GetParam()) ? 3 * seeds_per_family / 20 : 0);
}

/// Areas that are small compared with the coordinates: the longest edge tells whether a face is
/// degenerate.
TEST_P(Reference_test, gives_the_same_features_and_regions_far_from_the_origin)
{
  for (double distance : {1e5, 1e7, 1e9})
    for (const Options& options : {Options(1, reference::Convexity::concave, 5), Options(1)}) {
      SCOPED_TRACE(distance);
      const Soup soup = translated(random_mesh(GetParam(), 1), distance, 0, -distance);
      const auto expected = reference::two_step(soup.points, soup.polygons, options);
      const Result result = run(soup, options);
      EXPECT_EQ(result.regions, expected.region_id);
      EXPECT_EQ(result.features, expected.is_feature);
    }
}

/// A sheet of equal pyramids: each face is a region, of the same area and length of edges.
Soup pyramids(std::size_t nx, std::size_t ny)
{
  return mapped(grid(nx, ny), [](const Point& p) {
    return Point{p[0], p[1], double(int(p[0]) % 2 + int(p[1]) % 2)};
  });
}

/// The mean angles of sections that are equal in real numbers may differ by rounding, which then
/// decides.
void expect_no_difference_but_by_rounding(const Soup& soup, std::mt19937& random)
{
  Options options(1 + random() % 8, reference::Convexity::all);
  if (random() % 3 == 0)
    options.constrained_edges = random_edges(soup, 12, random);
  for (const double beta : {0., 0.1, 1.})
    for (const double gamma : {0., 0.6, 1.}) {
      options.beta = beta;
      options.gamma = gamma;
      SCOPED_TRACE("beta " + std::to_string(beta) + ", gamma " + std::to_string(gamma) + ", k " +
                   std::to_string(options.k));
      const auto expected = reference::two_step(soup.points, soup.polygons, options);
      const Result result = run(soup, options);
      if (!differs_by_a_tie(soup, options, expected, result.tree)) {
        EXPECT_EQ(result.segments, expected.segment_id);
      }
    }
}

TEST(Reference_ties_test, are_decided_by_rounding_at_most_with_all_weights)
{
  const unsigned first_seed = std::random_device{}();
  SCOPED_TRACE("seeds from " + std::to_string(first_seed));
  std::mt19937 random(first_seed);
  for (const Soup& soup : {cube(), l_shape(), box_on_plate(), dumbbell(), pillow(), cap(),
                           needle_on_crease(), joined(cube(), translated(cube(), 3, 0, 0))})
    expect_no_difference_but_by_rounding(soup, random);
  for (unsigned seed = first_seed; seed < first_seed + 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    random.seed(seed);
    Soup soup = seed % 4 == 0 ? pyramids(1 + random() % 8, 1 + random() % 6)
                              : random_blocks(random);
    if (random() % 2)
      soup = triangulated(soup);
    if (seed % 4 == 1)
      soup = joined(cube(), translated(soup, 40, 0, 0));
    shuffle_faces(soup, random);
    expect_no_difference_but_by_rounding(soup, random);
  }
}

INSTANTIATE_TEST_SUITE_P(families, Reference_test, ::testing::ValuesIn(all_families),
                         [](const auto& info) { return family_in_name(info.param); });

} // namespace reference_test
