// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Graph/merge_regions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace merge_regions_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;
using Graph = RS::Region_adjacency_graph<>;

struct Length_cost
{
  double operator()(const Graph& g, Graph::section_descriptor s) const { return g[s].length; }
};
using Shortest_first = RS::Lowest_cost_first<Length_cost>;

/// A path of n regions; section i, between i and i + 1, has length i + 1.
Graph path(std::size_t n)
{
  Graph g;
  for (std::uint32_t r = 0; r < n; ++r) {
    g.add_region();
    RS::Section_geometry data;
    data.length = double(r);
    data.number_of_adjacencies = 1;
    if (r > 0)
      g.add_section(r - 1, r, data);
  }
  return g;
}

TEST(Merge_regions_test, stops_at_a_count)
{
  Graph g = path(6);
  Shortest_first policy;
  const auto tree = RS::merge_regions(g, policy, 4);
  EXPECT_EQ(g.number_of_regions(), 4u);
  EXPECT_EQ(tree.number_of_regions(), 6u);
  ASSERT_EQ(tree.merges().size(), 2u);
  EXPECT_EQ(tree.merges()[1].removed, 2u);
  EXPECT_EQ(tree.merges()[1].cost, 2);
}

TEST(Merge_regions_test, ends_when_nothing_is_left_to_merge)
{
  Graph g = path(6);
  g.forbid_merge(*g.section(2, 3));
  Shortest_first policy;
  RS::merge_regions(g, policy, 1);
  EXPECT_EQ(g.number_of_regions(), 2u);
  Graph empty;
  EXPECT_TRUE(RS::merge_regions(empty, policy, 1).merges().empty());
}

TEST(Merge_regions_test, goes_on_with_a_graph_that_is_partly_merged)
{
  Graph g = path(6), at_once = path(6);
  Shortest_first policy;
  const auto first = RS::merge_regions(g, policy, 4);
  const auto second = RS::merge_regions(g, policy, 2);
  const auto all = RS::merge_regions(at_once, policy, 2);
  ASSERT_EQ(first.merges().size() + second.merges().size(), all.merges().size());
  EXPECT_EQ(second.merges().back().removed, all.merges().back().removed);
}

struct Counting_visitor
{
  std::vector<double> fractions;
  std::size_t cancel_at = 1000000;

  bool on_progress(const char* stage, double fraction)
  {
    EXPECT_STREQ(stage, "merging");
    fractions.push_back(fraction);
    return fractions.size() < cancel_at;
  }
};

TEST(Merge_regions_test, tells_a_visitor_about_a_hundred_times)
{
  Graph g = path(5000);
  Shortest_first policy;
  Counting_visitor visitor;
  RS::merge_regions(g, policy, 1, RS::parameters::visitor(std::ref(visitor)));
  EXPECT_GE(visitor.fractions.size(), 50u);
  EXPECT_LE(visitor.fractions.size(), 200u);
  EXPECT_EQ(visitor.fractions.front(), 0);
  EXPECT_GT(visitor.fractions.back(), 0.97);
  EXPECT_TRUE(std::is_sorted(visitor.fractions.begin(), visitor.fractions.end()));
  EXPECT_LE(visitor.fractions.back(), 1);
}

TEST(Merge_regions_test, a_cancelled_run_leaves_a_whole_graph)
{
  Graph g = path(50);
  Shortest_first policy;
  Counting_visitor visitor;
  visitor.cancel_at = 10;
  EXPECT_THROW(RS::merge_regions(g, policy, 1, RS::parameters::visitor(std::ref(visitor))),
               RS::Segmentation_cancelled);
  EXPECT_GT(g.number_of_regions(), 1u);
  EXPECT_LT(g.number_of_regions(), 50u);
  EXPECT_EQ(g.number_of_sections(), g.number_of_regions() - 1); // still a path
  RS::merge_regions(g, policy, 1);
  EXPECT_EQ(g.number_of_regions(), 1u);
}

/// Proposes the same section again and again.
struct Stubborn_policy
{
  Graph::section_descriptor section;

  void initialize(const Graph&) {}
  std::optional<RS::Merge_candidate> next(const Graph&) { return RS::Merge_candidate{section, 0}; }
  void on_merge(const Graph&, const Graph::Merge&) {}
};

TEST(Merge_regions_test, a_policy_that_proposes_what_cannot_be_merged_is_an_error)
{
  Graph g = path(4);
  const auto s = *g.section(1, 2);
  EXPECT_EQ(message_of<RS::Invalid_method>([&] { RS::merge_regions(g, Stubborn_policy{s}, 1); }),
            "the MergingPolicy proposes to merge across section " + std::to_string(s.id()) +
              ", which is removed");
  EXPECT_EQ(g.number_of_regions(), 3u);
  g.forbid_merge(*g.section(0, 1));
  EXPECT_THROW(RS::merge_regions(g, Stubborn_policy{*g.section(0, 1)}, 1), RS::Invalid_method)
    << "barred";
  EXPECT_EQ(g.number_of_regions(), 3u);
}

/// Proposes any section, at a cost that is not a number.
struct Policy_without_a_cost
{
  void initialize(const Graph&) {}
  std::optional<RS::Merge_candidate> next(const Graph& g)
  {
    return RS::Merge_candidate{*edges(g).first, std::numeric_limits<double>::quiet_NaN()};
  }
  void on_merge(const Graph&, const Graph::Merge&) {}
};

TEST(Merge_regions_test, a_policy_whose_cost_is_not_a_number_is_an_error)
{
  Graph g = path(4);
  EXPECT_EQ(
    message_of<RS::Invalid_method>([&] { RS::merge_regions(g, Policy_without_a_cost(), 1); }),
    "the MergingPolicy proposes to merge across section 0 at a cost that is not a number");
  EXPECT_EQ(g.number_of_regions(), 4u);
  EXPECT_NO_THROW(RS::merge_regions(g, Policy_without_a_cost(), 4)) << "nothing is merged";
}

/// A crumb over two plates: a wide end over the first one, where its links are longest, and a row
/// of 20 small squares over the second one, with which its contact is longest.
Soup crumb_over_two_plates()
{
  const double u = 1. / 256, height = 1e-6; // sums of u are exact
  Soup soup;
  const auto add = [&](const std::vector<Point>& corners) {
    Polygon polygon;
    for (const Point& p : corners) {
      const auto found = std::find(soup.points.begin(), soup.points.end(), p);
      polygon.push_back(std::size_t(found - soup.points.begin()));
      if (found == soup.points.end())
        soup.points.push_back(p);
    }
    soup.polygons.push_back(polygon);
  };
  const auto add_rectangle = [&](double x, double w, double y, double z) {
    add({{x, -y, z}, {x + w, -y, z}, {x + w, y, z}, {x, y, z}});
  };
  add_rectangle(-1, 1, 1, 0);
  add_rectangle(u / 4, 1, 0.9, -height / 4);
  add({{-2 * u, -u, height},
       {-u, -u, height},
       {-u, -u / 2, height},
       {-u, u / 2, height},
       {-u, u, height},
       {-2 * u, u, height}});
  add_rectangle(-u, u, u / 2, height);
  for (int i = 0; i < 20; ++i)
    add_rectangle(i * u, u, u / 2, height);
  return soup;
}

// It joined the plate of the longest single link.
TEST(Merge_requested_regions_test, a_crumb_joins_the_component_with_the_longest_contact)
{
  const Soup soup = crumb_over_two_plates();
  std::vector<std::size_t> labels(soup.polygons.size());
  EXPECT_EQ(RS::segment_polygon_soup(soup.points, soup.polygons, labels,
                                     RS::parameters::number_of_segments(2).method(RS::Two_step())),
            2u);
  Labels expected(soup.polygons.size(), 1);
  expected[0] = 0;
  EXPECT_EQ(labels, expected);
}

} // namespace merge_regions_test
