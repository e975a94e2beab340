// SPDX-License-Identifier: GPL-3.0-or-later

// The policies, on graphs whose numbers are given directly. (reference_test.cpp: each choice of
// Two_step on random meshes.)

#include "oracles.h"

#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/merge_regions.h>
#include <CGAL/Region_segmentation/Two_step/Least_compact_region_first.h>
#include <CGAL/Region_segmentation/Two_step/Smallest_region_first.h>
#include <CGAL/Region_segmentation/Two_step/longest_flattest_section.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <tuple>

namespace policies_test {

namespace RS = CGAL::Region_segmentation;
using Graph = RS::Region_adjacency_graph<>;
const double pi = std::acos(-1.0);

void add_region(Graph& g, double area, double perimeter = 1)
{
  RS::Region_geometry data;
  data.area = area;
  data.perimeter = perimeter;
  g.add_region(data);
}

RS::Section_descriptor add_section(Graph& g, std::uint32_t a, std::uint32_t b, double length,
                                   double angle = pi / 2)
{
  RS::Section_geometry data;
  data.length = length;
  data.sum_of_angles = angle;
  data.number_of_adjacencies = 1;
  return g.add_section(a, b, data);
}

/// Region 0 and neighbors 1, 2, ... with the given length and angle.
Graph star(const std::vector<std::pair<double, double>>& sections)
{
  Graph g;
  for (std::size_t i = 0; i <= sections.size(); ++i)
    add_region(g, double(i + 1));
  for (std::size_t i = 0; i < sections.size(); ++i)
    add_section(g, 0, std::uint32_t(i + 1), sections[i].first, sections[i].second);
  return g;
}

std::uint32_t chosen(const Graph& g, double beta, std::uint32_t region = 0)
{
  return target(*RS::longest_flattest_section(g, region, beta), g);
}

using Merges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

template <typename Policy>
Merges merges(Graph g, Policy policy, std::size_t k = 1)
{
  Merges result;
  const auto tree = RS::merge_regions(g, policy, k);
  for (const auto& m : tree.merges())
    result.push_back({m.kept, m.removed});
  return result;
}

TEST(Longest_flattest_section_test, equal_sums_go_to_the_lower_neighbor)
{
  EXPECT_EQ(chosen(star({{2, 1}, {2, 1}, {2, 1}}), 0.1), 1u);
  EXPECT_EQ(chosen(star({{1, 1}, {2, 1}, {2, 1}}), 0.1), 2u);
}

// The longer of two equally flat sections was taken with beta 0, the flatter of two equally long
// ones with beta 1.
TEST(Longest_flattest_section_test, what_has_no_weight_decides_nothing)
{
  EXPECT_EQ(chosen(star({{1, 1}, {2, 1}, {3, 1}}), 0), 1u);
  EXPECT_EQ(chosen(star({{1, 1}, {2, 3}, {5, 3}, {4, 2}}), 0), 2u);
  EXPECT_EQ(chosen(star({{2, 1}, {2, 2}, {2, 3}, {1, 3}}), 1), 1u);
}

/// Links are candidates for a region that cannot be merged across edges: such a region was never
/// merged across a link if it had a constrained edge.
TEST(Longest_flattest_section_test, links_are_for_regions_without_edges_to_merge_across)
{
  Graph g = star({{3, 3}, {1, 1}, {2, 2}});
  for (const std::uint32_t neighbor : {1u, 3u}) {
    RS::Section_geometry& data = g[*g.section(0, neighbor)];
    data.link_length = data.length;
    data.number_of_links = data.number_of_adjacencies;
  }
  EXPECT_EQ(chosen(g, 0.1), 2u);
  g.forbid_merge(*g.section(0, 2));
  EXPECT_EQ(chosen(g, 0.1), 1u);
  for (const std::uint32_t neighbor : {1u, 3u})
    g.forbid_merge(*g.section(0, neighbor));
  EXPECT_FALSE(RS::longest_flattest_section(g, 0, 0.1));
}

TEST(Longest_flattest_section_test, zero_over_zero_is_a_half)
{
  EXPECT_EQ(chosen(star({{0, 0}, {0, 0}}), 0.1), 1u);
  EXPECT_EQ(chosen(star({{0, 0}, {0, 1}}), 0.1), 2u);
}

/// Areas with ties, without any area, of any size, all equal, and infinite.
double area_of_kind(unsigned kind, std::mt19937& random)
{
  switch (kind) {
  case 0:
    return 1 + double(random() % 20);
  case 1:
    return random() % 3 ? double(random() % 100) : 0;
  case 2:
    return std::pow(10, double(random() % 6000) / 10 - 300);
  case 3:
    return 2.5;
  default:
    return random() % 2 ? 1 + 1e-12 * double(random() % 1000)
                        : std::numeric_limits<double>::infinity();
  }
}

TEST(Smallest_region_first_test, is_the_greedy_order)
{
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Graph g;
    const std::size_t n = 2 + random() % 500;
    for (std::size_t r = 0; r < n; ++r)
      add_region(g, area_of_kind(seed % 5, random));
    for (std::size_t i = 3 * n; i > 0; --i) {
      const std::uint32_t a = random() % n, b = random() % (random() % 4 ? n : 2); // two hubs
      if (a != b && !g.section(a, b)) {
        const auto s = add_section(g, a, b, double(1 + random() % 6), double(1 + random() % 3));
        if (random() % 8 == 0)
          g.forbid_merge(s);
      }
    }
    Graph slow = g;
    Merges expected;
    while (true) {
      std::set<std::pair<double, std::uint32_t>> regions;
      for (auto [it, end] = vertices(slow); it != end; ++it)
        regions.insert({slow[*it].area, *it});
      const auto best = std::find_if(regions.begin(), regions.end(), [&](const auto& r) {
        return RS::longest_flattest_section(slow, r.second, 0.1).has_value();
      });
      if (best == regions.end())
        break;
      const auto merge = slow.merge(*RS::longest_flattest_section(slow, best->second, 0.1));
      expected.push_back({merge.kept, merge.removed});
    }
    EXPECT_GT(expected.size(), n / 2);
    EXPECT_EQ(merges(g, RS::Smallest_region_first()), expected);
  }
}

// Entries that were left in the queue once took part in the next run, outside of its buckets.
TEST(Smallest_region_first_test, can_be_used_again_after_a_run_that_was_stopped)
{
  const auto chain = [](std::size_t size, double unit) {
    Graph g;
    for (std::size_t i = 0; i < size; ++i)
      add_region(g, unit * double(1 + i * 7919 % size));
    for (std::uint32_t i = 0; i + 1 < size; ++i)
      add_section(g, i, i + 1, 1);
    return g;
  };
  RS::Smallest_region_first policy;
  Graph first = chain(20000, 1e6);
  RS::merge_regions(first, policy, 5000);
  for (const std::size_t size : {300, 3000, 30000}) {
    Graph again = chain(size, 1e-3);
    const RS::Merge_tree tree = RS::merge_regions(again, policy, 5);
    Merges pairs;
    for (const auto& m : tree.merges())
      pairs.push_back({m.kept, m.removed});
    EXPECT_EQ(pairs, merges(chain(size, 1e-3), RS::Smallest_region_first(), 5)) << size;
  }
}

TEST(Smallest_region_first_test, leaves_out_what_has_no_number_as_area)
{
  Graph g;
  for (double area : {std::nan(""), 2.0, 1.0, std::nan("")})
    add_region(g, area);
  add_section(g, 0, 1, 1);
  add_section(g, 1, 2, 2);
  add_section(g, 0, 3, 2);
  EXPECT_EQ(merges(g, RS::Smallest_region_first()), (Merges{{1, 2}, {0, 1}}));
}

TEST(Smallest_region_first_test, the_cost_is_the_area)
{
  Graph g = star({{1, 1}, {2, 2}});
  RS::Smallest_region_first policy;
  const auto tree = RS::merge_regions(g, policy, 1);
  ASSERT_EQ(tree.merges().size(), 2u);
  EXPECT_EQ(tree.merges()[0].cost, 1);
  EXPECT_EQ(tree.merges()[1].cost, 2); // region 1, not the merged one of area 1 + 3
}

TEST(Planarity_test, is_one_for_a_disc_and_infinite_without_area)
{
  RS::Region_geometry disc;
  disc.area = pi * 9;
  disc.perimeter = 2 * pi * 3;
  EXPECT_NEAR(RS::planarity(disc), 1, 1e-15);
  RS::Region_geometry square;
  square.area = 4;
  square.perimeter = 8;
  EXPECT_NEAR(RS::planarity(square), 4 / pi, 1e-15);
  EXPECT_EQ(RS::planarity(RS::Region_geometry()), std::numeric_limits<double>::infinity());
}

TEST(Least_compact_region_first_test, costs_are_means_over_the_other_regions)
{
  const auto costs = [](std::vector<double> areas) {
    Graph g;
    for (const double area : areas)
      add_region(g, area, 1);
    for (std::uint32_t r = 1; r < areas.size(); ++r)
      add_section(g, r - 1, r, 1);
    RS::Least_compact_region_first policy(0.1, 0); // by area alone
    std::vector<double> result;
    for (const auto& merge : RS::merge_regions(g, policy, 1).merges())
      result.push_back(merge.cost);
    return result;
  };
  const std::vector<double> of_two = costs({1, 1}), of_three = costs({1, 2, 4});
  ASSERT_EQ(of_two.size(), 1u);
  EXPECT_NEAR(of_two[0], 1. / 2, 1e-10);
  ASSERT_EQ(of_three.size(), 2u);
  EXPECT_NEAR(of_three[0], (1. / 3 + 1. / 5) / 2, 1e-10);
  EXPECT_NEAR(of_three[1], 3. / 7, 1e-10);
}

/// Merging makes regions of the same area and planarity as others: some of their sums were computed
/// anew and others were updated, and rounding decided between them.
TEST(Least_compact_region_first_test, equal_regions_are_told_apart_by_ids_alone)
{
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Graph g;
    const std::size_t n = 4 + random() % 30;
    for (std::size_t r = 0; r < n; ++r)
      add_region(g, double(1 + random() % 3), double(4 + random() % 3));
    for (std::size_t i = 3 * n; i > 0; --i) {
      const std::uint32_t a = random() % n, b = random() % n;
      if (a != b && !g.section(a, b))
        add_section(g, a, b, 0.125);
    }
    for (const double gamma : {0., 0.6, 1.}) {
      Graph slow = g;
      Merges expected;
      while (true) { // a new policy sums anew
        const auto best = RS::Least_compact_region_first(0.1, gamma);
        RS::Merge_tree tree = RS::merge_regions(slow, best, slow.number_of_regions() - 1);
        if (tree.merges().empty())
          break;
        expected.push_back({tree.merges()[0].kept, tree.merges()[0].removed});
      }
      EXPECT_EQ(merges(g, RS::Least_compact_region_first(0.1, gamma)), expected) << gamma;
    }
  }
}

TEST(Least_compact_region_first_test, takes_planarities_of_any_size)
{
  Graph g;
  for (double area : {0.0, 1e-300, 1.0, 0.0, 1e300})
    add_region(g, area, 1e3);
  for (std::uint32_t r = 1; r < 5; ++r)
    add_section(g, r - 1, r, 1);
  RS::Least_compact_region_first policy;
  const auto tree = RS::merge_regions(g, policy, 1);
  ASSERT_EQ(tree.merges().size(), 4u);
  for (const auto& m : tree.merges()) {
    EXPECT_GE(m.cost, 0);
    EXPECT_LE(m.cost, 1);
  }
}

struct Length_cost
{
  double operator()(const Graph& g, Graph::section_descriptor s) const { return g[s].length; }
};

TEST(Lowest_cost_first_test, is_the_greedy_order)
{
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Graph g;
    const std::size_t n = 2 + random() % 25;
    for (std::size_t r = 0; r < n; ++r)
      add_region(g, 1);
    for (std::size_t i = 3 * n; i > 0; --i) {
      const std::uint32_t a = random() % n, b = random() % n;
      if (a != b && !g.section(a, b)) {
        const auto s = add_section(g, a, b, double(1 + random() % 6)); // with ties
        if (random() % 8 == 0)
          g.forbid_merge(s);
      }
    }
    Graph slow = g;
    Merges expected;
    while (true) {
      std::tuple<double, std::uint32_t, std::uint32_t> best{1e300, 0, 0};
      for (auto [it, end] = edges(slow); it != end; ++it) {
        const auto [low, high] = std::minmax({source(*it, slow), target(*it, slow)});
        if (slow.is_mergeable(*it))
          best = (std::min)(best, std::make_tuple(slow[*it].length, low, high));
      }
      if (std::get<0>(best) == 1e300)
        break;
      expected.push_back({std::get<1>(best), std::get<2>(best)});
      slow.merge(*slow.section(std::get<1>(best), std::get<2>(best)));
    }
    EXPECT_EQ(merges(g, RS::Lowest_cost_first<Length_cost>()), expected);
  }
}

/// Depends on a region: the share of the section's length in its area; counts how often it is
/// evaluated.
struct Counting_cost
{
  std::size_t* evaluations;

  template <typename Graph>
  double operator()(const Graph& g, typename Graph::section_descriptor s) const
  {
    ++*evaluations;
    return -g[s].length / (1 + 1e-9 * (g[g.source(s)].area + g[g.target(s)].area));
  }
};

TEST(Lowest_cost_first_test, merging_into_a_hub_takes_linear_time)
{
  std::vector<std::size_t> evaluations;
  for (const std::size_t degree : {10000, 20000}) {
    std::vector<std::pair<double, double>> sections;
    for (std::size_t i = 0; i < degree; ++i)
      sections.push_back({double(1 + i * 7919 % degree), 1});
    std::size_t number = 0;
    const Merges found = merges(star(sections),
                                RS::Lowest_cost_first<Counting_cost>(Counting_cost{&number}));
    EXPECT_EQ(found.size(), degree);
    evaluations.push_back(number);
  }
  EXPECT_LT(evaluations[1], 3 * evaluations[0]) << "not four times as many";
  EXPECT_LT(evaluations[1], 2 * 1024 * 20000u);
}

/// Merges of a hub: all costs anew, or none.
TEST(Lowest_cost_first_test, costs_at_a_hub_lag_as_documented)
{
  const std::size_t degree = 3000, bound = RS::Lowest_cost_first<Length_cost>::hub_degree;
  std::mt19937 random(3);
  Graph g;
  for (std::size_t i = 0; i <= degree; ++i)
    add_region(g, i == 0 ? 1e9 : double(1 + random() % 1000));
  for (std::uint32_t i = 1; i <= degree; ++i)
    add_section(g, 0, i, double(1 + random() % 100000));
  for (std::uint32_t i = 1; i + 1 < degree; i += 3)
    add_section(g, i, i + 1, double(1 + random() % 1000));
  std::size_t ignored = 0;
  const Counting_cost cost{&ignored};

  Merges expected;
  Graph h = g;
  std::map<std::uint32_t, double> cost_of; // by section
  const auto update = [&](RS::Section_descriptor s) { cost_of[s.id()] = cost(h, s); };
  for (auto range = edges(h); range.first != range.second; ++range.first)
    update(*range.first);
  std::map<std::uint32_t, std::size_t> merges_since;
  while (h.number_of_sections() > 0) {
    std::optional<RS::Section_descriptor> best;
    std::tuple<double, std::uint32_t, std::uint32_t> lowest;
    for (auto range = edges(h); range.first != range.second; ++range.first) {
      const std::uint32_t a = h.source(*range.first), b = h.target(*range.first);
      const std::tuple<double, std::uint32_t, std::uint32_t> key(cost_of[range.first->id()],
                                                                 std::min(a, b), std::max(a, b));
      if (!best || key < lowest) {
        best = *range.first;
        lowest = key;
      }
    }
    const auto merge = h.merge(*best);
    expected.push_back({merge.kept, merge.removed});
    std::size_t& since = merges_since[merge.kept];
    since = std::max(since, merges_since[merge.removed]) + 1;
    if (since >= h.degree(merge.kept) / bound) {
      since = 0;
      for (auto s : h.sections(merge.kept))
        update(s);
    }
  }
  EXPECT_EQ(merges(g, RS::Lowest_cost_first<Counting_cost>(cost)), expected);
}

struct Nan_for_long
{
  double operator()(const Graph& g, Graph::section_descriptor s) const
  {
    return g[s].length > 1 ? std::nan("") : g[s].length;
  }
};

TEST(Lowest_cost_first_test, what_costs_no_number_is_never_merged)
{
  EXPECT_EQ(merges(star({{1, 1}, {2, 1}, {0.5, 1}}), RS::Lowest_cost_first<Nan_for_long>()),
            (Merges{{0, 3}, {0, 1}}));
}

/// Takes any section, and remembers what it was told.
struct Recording_policy
{
  std::vector<std::string>* calls;
  std::string name;

  template <typename G>
  void initialize(const G& g)
  {
    calls->push_back(name + " initialize " + std::to_string(g.number_of_regions()));
  }
  template <typename G>
  std::optional<RS::Merge_candidate> next(const G& g)
  {
    const auto range = edges(g);
    if (range.first == range.second)
      return std::nullopt;
    return RS::Merge_candidate{*range.first, 0};
  }
  template <typename G>
  void on_merge(const G& g, const typename G::Merge&)
  {
    calls->push_back(name + " merge " + std::to_string(g.number_of_regions()));
  }
};

using Recording_phases = RS::Policy_phases<Recording_policy, Recording_policy>;

std::vector<std::string> calls_of(std::size_t regions, std::size_t k, std::size_t until)
{
  std::vector<std::string> calls;
  Graph g = star(std::vector<std::pair<double, double>>(regions - 1, {1, 1}));
  RS::merge_regions(g, Recording_phases{{{&calls, "first"}, until}, {{&calls, "second"}, 1}}, k);
  return calls;
}

TEST(Policy_phases_test, the_second_takes_over_at_the_number_of_the_first)
{
  EXPECT_EQ(calls_of(6, 2, 4),
            (std::vector<std::string>{"first initialize 6", "first merge 5", "first merge 4",
                                      "second initialize 4", "second merge 3", "second merge 2"}));
  EXPECT_EQ(calls_of(3, 2, 4), (std::vector<std::string>{"second initialize 3", "second merge 2"}))
    << "at once";
  EXPECT_EQ(calls_of(3, 2, 1), (std::vector<std::string>{"first initialize 3", "first merge 2"}))
    << "it is not needed";
}

TEST(Policy_phases_test, the_first_that_has_no_candidate_ends_merging)
{
  std::vector<std::string> calls;
  Graph g = star({{1, 1}, {1, 1}, {1, 1}});
  for (std::uint32_t r = 1; r < 4; ++r)
    g.forbid_merge(*g.section(0, r));
  const RS::Policy_phases<RS::Smallest_region_first, Recording_policy> phases{
    {RS::Smallest_region_first(), 2}, {{&calls, "second"}, 1}};
  EXPECT_TRUE(merges(g, phases).empty());
  EXPECT_TRUE(calls.empty());
}

} // namespace policies_test
