// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/merge_regions.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

namespace RS = CGAL::Region_segmentation;

namespace Learned_cost_test {

using Model = RS::Merge_model;

int any_of(std::mt19937& random, int from, int to)
{
  return from + int(random() % unsigned(to - from + 1));
}

using Graph = RS::Region_adjacency_graph<RS::Learned_region_data, RS::Learned_section_data>;

/// Regions in a grid with random areas, sections with random lengths and angles.
Graph random_graph(std::mt19937& random)
{
  std::uniform_real_distribution<double> any(0.01, 1);
  Graph graph;
  const std::uint32_t n = 6;
  for (std::uint32_t i = 0; i < n * n; ++i) {
    RS::Learned_region_data region;
    region.area = any(random) / (n * n);
    region.log_thickness = -any(random) * region.area;
    region.visibility = any(random);
    region.perimeter = 4;
    region.moments.add(region.area, {any(random), any(random), any(random)});
    graph.add_region(region);
  }
  for (std::uint32_t i = 0; i < n * n; ++i)
    for (std::uint32_t j : {i % n + 1 < n ? i + 1 : i, i + n < n * n ? i + n : i})
      if (j != i) {
        RS::Learned_section_data section;
        section.length = any(random);
        section.concave = 0.5 * any(random) * section.length;
        section.number_of_adjacencies = 1;
        graph.add_section(i, j, section);
      }
  return graph;
}

/// A model that knows one feature: the log odds are 1 - 4 times the concavity.
Model concavity_model()
{
  constexpr std::size_t concave = 2; // its place
  Model model;
  model.name = "concavity-1";
  model.inputs[concave].factor = 1 << (Model::factor_bits + Model::input_bits - 9);
  model.direct_weights[concave] = -4 * 1024;
  model.output_bias = std::int64_t(1) << 26;
  return model;
}

TEST(Merge_model_test, portable_exp_is_nearly_exp)
{
  for (double x = -64; x <= 64; x += 0.37)
    EXPECT_NEAR(RS::internal::portable_exp(x) / std::exp(x), 1, 1e-9 + x * x / (1 << 17));
  EXPECT_EQ(RS::internal::portable_exp(0), 1);
}

TEST(Learned_cost_test, is_the_formula_of_its_documentation)
{
  std::mt19937 random(7);
  const Graph graph = random_graph(random);
  const RS::Learned_cost cost(concavity_model());
  for (auto range = edges(graph); range.first != range.second; ++range.first) {
    const auto& section = graph[*range.first];
    const double p = 1 / (1 + std::exp(-(1 - 4 * section.concave / section.length)));
    EXPECT_NEAR(RS::Merge_estimate(*cost.model, graph, *range.first).probability, p, 6e-3);
    const double w = graph[graph.source(*range.first)].area *
                     graph[graph.target(*range.first)].area;
    const double z = 1 - 2 * p;
    EXPECT_NEAR(cost(graph, *range.first),
                z * std::pow(w / 0.01, z < 0 ? 0.1 : 0.2) +
                  0.1 * RS::Visibility_cost()(graph, *range.first),
                0.02);
    EXPECT_NEAR(cost.recorded_cost(graph, *range.first) / w, 1 - 2 * p, 0.02);
  }
}

TEST(Learned_cost_test, records_another_cost_than_that_of_the_order)
{
  std::mt19937 random(8);
  const Graph graph = random_graph(random);
  const RS::Learned_cost cost(concavity_model());
  const auto order = [&](const auto& g, auto s) { return cost(g, s); };
  Graph a = graph, b = graph, c = graph;
  const RS::Merge_tree by_order = merge_regions(a, RS::Lowest_cost_first(order), 1);
  const RS::Merge_tree both = merge_regions(b, RS::Lowest_cost_first(cost), 1);
  ASSERT_EQ(both.merges().size(), graph.number_of_regions() - 1);
  ASSERT_EQ(both.merges().size(), by_order.merges().size());
  for (std::size_t i = 0; i < both.merges().size(); ++i) {
    const auto &x = by_order.merges()[i], &y = both.merges()[i];
    EXPECT_EQ(x.kept, y.kept);
    EXPECT_EQ(x.removed, y.removed);
    const auto section = *c.section(y.kept, y.removed);
    EXPECT_EQ(x.cost, cost(c, section));
    EXPECT_EQ(y.cost, cost.recorded_cost(c, section));
    c.merge(section);
  }
}

TEST(Learned_merging_test, a_model_of_a_user_is_shared_by_copies_that_outlive_the_original)
{
  std::optional<RS::Learned_merging> original(concavity_model());
  const RS::Learned_merging copy = *original;
  EXPECT_EQ(&copy.model(), &original->model());
  original.reset();
  EXPECT_EQ(copy.model().name, "concavity-1");
  EXPECT_EQ(RS::Learned_merging().model().name, "learned-3");

  std::mt19937 random(9);
  const Graph graph = random_graph(random);
  const RS::Learned_cost cost = std::get<2>(copy.policy).first.cost();
  const auto section = *edges(graph).first;
  EXPECT_EQ(cost(graph, section), RS::Learned_cost(concavity_model())(graph, section));
  EXPECT_NE(cost(graph, section), RS::Learned_cost(RS::Merge_model())(graph, section));
}

TEST(Number_from_expected_costs_test, is_where_the_sum_is_lowest)
{
  RS::Number_from_expected_costs chooser;
  chooser.maximum_number = 12;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::size_t regions = 1 + random() % 30,
                      components = 1 + random() % (std::min)(regions, std::size_t(4));
    RS::Merge_tree tree(regions);
    std::vector<double> cost_to(regions + 1, 0); // of the merge that leaves n regions
    for (std::size_t n = regions; n-- > components;) {
      cost_to[n] = any_of(random, -10, 10);
      tree.push_back({0, std::uint32_t(n), cost_to[n]});
    }
    const std::size_t most = std::max(components, std::min<std::size_t>(12, regions));
    const std::size_t least = std::max(components, std::min<std::size_t>(2, regions));
    double lowest = 1e9;
    std::size_t best = 0;
    for (std::size_t k = std::max(least, most); k >= least; --k) {
      double sum = 0;
      for (std::size_t n = k; n < most; ++n)
        sum += cost_to[n];
      if (sum < lowest) {
        lowest = sum;
        best = k;
      }
    }
    EXPECT_EQ(chooser(tree), best);
  }
}

TEST(Number_from_expected_costs_test, granularity_multiplies_every_cost_above_0)
{
  // Two merges of .5 that do not pay, then two that do, by .7 each: from 5 regions on to 1, unless
  // the first two cost more.
  RS::Merge_tree tree(5);
  std::uint32_t n = 5;
  for (double cost : {0.5, 0.5, -0.7, -0.7})
    tree.push_back({0, --n, cost});
  RS::Number_from_expected_costs chooser;
  chooser.minimum_number = 1;
  EXPECT_EQ(chooser(tree), 1u);
  chooser.granularity = 1.3; // 1.3 - 1.4 < 0
  EXPECT_EQ(chooser(tree), 1u);
  chooser.granularity = 1.5; // 1.5 - 1.4 > 0
  EXPECT_EQ(chooser(tree), 5u);
}

TEST(Number_from_expected_costs_test, of_few_regions)
{
  const RS::Number_from_expected_costs chooser{};
  EXPECT_EQ(chooser(RS::Merge_tree(0)), 0u);
  EXPECT_EQ(chooser(RS::Merge_tree(1)), 1u);
  EXPECT_EQ(chooser(RS::Merge_tree(5)), 5u); // five components
}

} // namespace Learned_cost_test
