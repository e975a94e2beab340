// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>

#include <boost/concept/assert.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace {

namespace RS = CGAL::Region_segmentation;
using namespace test;
using Graph = RS::Region_adjacency_graph<>;
using Region = Graph::region_descriptor;
using Section = Graph::section_descriptor;

BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, Region, boost::vertex_index_t>));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, Section, boost::edge_index_t>));

RS::Region_geometry region(double area, double perimeter = 0)
{
  RS::Region_geometry data;
  data.area = area;
  data.perimeter = perimeter;
  return data;
}

RS::Section_geometry section(double length, double sum_of_angles = 1, std::size_t edges = 1)
{
  RS::Section_geometry data;
  data.length = length;
  data.sum_of_angles = sum_of_angles;
  data.number_of_edges = edges;
  return data;
}

//     0---1---2      and 4 alone
//      \  |  /
//       \ | /
//         3
Graph kite()
{
  Graph g;
  for (double area : {1, 2, 4, 8, 16})
    g.add_region(region(area));
  g.add_section(0, 1, section(1));
  g.add_section(1, 2, section(2));
  g.add_section(0, 3, section(3));
  g.add_section(1, 3, section(5));
  g.add_section(2, 3, section(4));
  return g;
}

std::size_t number_of_components(const Graph& g)
{
  std::vector<std::size_t> component(num_vertices(g));
  return boost::connected_components(
      g, boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, g)));
}

auto lengths(const Graph& g)
{
  return boost::make_function_property_map<Section>([&g](Section s) { return g[s].length; });
}

double minimum_spanning_length(const Graph& g)
{
  std::vector<Section> tree;
  boost::kruskal_minimum_spanning_tree(g, std::back_inserter(tree), boost::weight_map(lengths(g)));
  double sum = 0;
  for (Section s : tree)
    sum += g[s].length;
  return sum;
}

double distance(const Graph& g, Region from, Region to)
{
  std::vector<double> distances(num_vertices(g));
  std::vector<Region> predecessors(num_vertices(g));
  boost::dijkstra_shortest_paths(g, from,
                                 boost::weight_map(lengths(g))
                                     .distance_map(boost::make_iterator_property_map(
                                         distances.begin(), get(boost::vertex_index, g)))
                                     .predecessor_map(boost::make_iterator_property_map(
                                         predecessors.begin(), get(boost::vertex_index, g))));
  return distances[to];
}

TEST(Region_adjacency_graph_test, algorithms_of_boost_run_before_and_after_merges)
{
  Graph g = kite();
  EXPECT_EQ(number_of_components(g), 2u);
  EXPECT_EQ(minimum_spanning_length(g), 1 + 2 + 3);
  EXPECT_EQ(distance(g, 0, 2), 3);
  EXPECT_EQ(distance(g, 2, 3), 4);

  // 1 takes in 3:   0 --(1 + 3)-- 1 --(2 + 4)-- 2
  g.merge(*g.section(1, 3));
  EXPECT_EQ(number_of_components(g), 2u);
  EXPECT_EQ(minimum_spanning_length(g), 4 + 6);
  EXPECT_EQ(distance(g, 0, 2), 10);
  g.merge(*g.section(0, 1));
  g.merge(*g.section(0, 2));
  EXPECT_EQ(number_of_components(g), 2u);
  EXPECT_EQ(minimum_spanning_length(g), 0);
}

TEST(Region_adjacency_graph_test, a_merge_keeps_the_lower_id_and_adds_up)
{
  Graph g = kite();
  const auto merge = g.merge(*g.section(3, 1));
  EXPECT_EQ(merge.kept, 1u);
  EXPECT_EQ(merge.removed, 3u);
  EXPECT_EQ(g[1].area, 2 + 8);
  EXPECT_EQ(g[1].perimeter, -2 * 5);
  EXPECT_EQ(g[*g.section(0, 1)].length, 1 + 3);
  EXPECT_EQ(g[*g.section(0, 1)].number_of_edges, 2u);
  EXPECT_EQ(g[*g.section(2, 1)].length, 2 + 4);
  EXPECT_TRUE(g.is_removed(Region(3)));
  EXPECT_EQ(g.number_of_regions(), 4u);
  EXPECT_EQ(g.number_of_sections(), 2u);
  EXPECT_EQ(degree(1, g), 2u);
  EXPECT_EQ(degree(4, g), 0u);
}

TEST(Region_adjacency_graph_test, descriptors_stay_valid)
{
  Graph g = kite();
  const Section s01 = *g.section(0, 1), s12 = *g.section(1, 2);
  g.merge(*g.section(2, 3)); // 1 has two sections to it, which become one
  EXPECT_FALSE(g.is_removed(s01));
  EXPECT_EQ(g[s01].length, 1);
  EXPECT_EQ(s01, *g.section(1, 0));
  // Of the two that became one, one is left, whichever it is.
  const Section left = *g.section(1, 2);
  EXPECT_EQ(g[left].length, 2 + 5);
  EXPECT_EQ(g.is_removed(s12), s12 != left);
  EXPECT_EQ(source(left, g), 1u);
  EXPECT_EQ(target(left, g), 2u);
}

TEST(Region_adjacency_graph_test, forbidding_is_passed_on)
{
  Graph g = kite();
  g.forbid_merge(*g.section(0, 3));
  EXPECT_FALSE(g.is_mergeable(*g.section(3, 0)));
  EXPECT_TRUE(g.is_mergeable(*g.section(0, 1)));
  g.merge(*g.section(1, 3));
  EXPECT_FALSE(g.is_mergeable(*g.section(0, 1)));
  EXPECT_TRUE(g.is_mergeable(*g.section(1, 2)));
}

TEST(Region_adjacency_graph_test, an_empty_graph)
{
  const Graph g;
  EXPECT_EQ(vertices(g).first, vertices(g).second);
  EXPECT_EQ(edges(g).first, edges(g).second);
  EXPECT_EQ(num_vertices(g), 0u);
}

// Against maps of maps, merge by merge.

struct Oracle
{
  struct Data
  {
    double length;
    std::size_t edges;
    bool is_mergeable;
  };
  std::map<Region, double> area;
  std::map<std::pair<Region, Region>, Data> sections; // lower region first

  void merge(Region a, Region b)
  {
    const Region kept = (std::min)(a, b), removed = (std::max)(a, b);
    area[kept] += area[removed];
    area.erase(removed);
    sections.erase({kept, removed});
    const auto old = sections;
    sections.clear();
    for (const auto& [pair, data] : old) {
      const Region x = pair.first == removed ? kept : pair.first;
      const Region y = pair.second == removed ? kept : pair.second;
      const auto [place, is_new] = sections.insert({{(std::min)(x, y), (std::max)(x, y)}, data});
      if (!is_new)
        place->second = {place->second.length + data.length, place->second.edges + data.edges,
                         place->second.is_mergeable && data.is_mergeable};
    }
  }
};

void expect_equal(const Graph& g, const Oracle& oracle)
{
  ASSERT_EQ(g.number_of_regions(), oracle.area.size());
  ASSERT_EQ(g.number_of_sections(), oracle.sections.size());
  std::vector<Region> regions(vertices(g).first, vertices(g).second), expected;
  std::map<Region, std::set<Region>> neighbors;
  for (const auto& [r, area] : oracle.area) {
    expected.push_back(r);
    ASSERT_EQ(g[r].area, area); // small integers: exact
  }
  ASSERT_EQ(regions, expected);
  for (const auto& [pair, data] : oracle.sections) {
    const auto [s, is_there] = edge(pair.first, pair.second, g);
    ASSERT_TRUE(is_there);
    ASSERT_FALSE(g.is_removed(s));
    ASSERT_EQ(source(s, g), pair.first);
    ASSERT_EQ(target(s, g), pair.second);
    ASSERT_EQ(g[s].length, data.length);
    ASSERT_EQ(g[s].number_of_edges, data.edges);
    ASSERT_EQ(g.is_mergeable(s), data.is_mergeable);
    neighbors[pair.first].insert(pair.second);
    neighbors[pair.second].insert(pair.first);
  }
  std::set<std::pair<Region, Region>> listed;
  for (auto [it, end] = edges(g); it != end; ++it) {
    const Region a = source(*it, g), b = target(*it, g);
    ASSERT_TRUE(listed.insert({(std::min)(a, b), (std::max)(a, b)}).second);
  }
  ASSERT_EQ(listed.size(), oracle.sections.size());
  for (Region r : regions) {
    const auto range = adjacent_vertices(r, g);
    const std::vector<Region> around(range.first, range.second);
    ASSERT_EQ(std::set<Region>(around.begin(), around.end()), neighbors[r]);
    ASSERT_EQ(around.size(), neighbors[r].size());
    ASSERT_EQ(out_degree(r, g), around.size());
    for (auto [it, end] = out_edges(r, g); it != end; ++it)
      ASSERT_EQ(source(*it, g), r);
  }
}

TEST(Region_adjacency_graph_test, agrees_with_maps_over_random_merges)
{
  for (unsigned seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Graph g;
    Oracle oracle;
    const std::size_t n = 2 + random() % 40;
    for (std::size_t r = 0; r < n; ++r) {
      const double area = double(random() % 100);
      oracle.area[g.add_region(region(area))] = area;
    }
    for (std::size_t i = random() % (3 * n); i > 0; --i) {
      const Region a = random() % n, b = seed % 3 ? random() % n : 0; // or a star
      if (a == b || g.section(a, b))
        continue;
      const double length = double(random() % 100);
      const Section s = g.add_section(a, b, section(length));
      ASSERT_EQ(source(s, g), a);
      const bool is_mergeable = random() % 10 != 0;
      if (!is_mergeable)
        g.forbid_merge(s);
      oracle.sections[{(std::min)(a, b), (std::max)(a, b)}] = {length, 1, is_mergeable};
    }
    while (true) {
      ASSERT_NO_FATAL_FAILURE(expect_equal(g, oracle));
      std::vector<std::pair<Region, Region>> ways;
      for (const auto& [pair, data] : oracle.sections)
        if (data.is_mergeable)
          ways.push_back(pair);
      if (ways.empty())
        break;
      const auto [a, b] = ways[random() % ways.size()];
      const auto merge = random() % 2 ? g.merge(*g.section(a, b)) : g.merge(*g.section(b, a));
      ASSERT_EQ(merge.kept, a);
      ASSERT_EQ(merge.removed, b);
      oracle.merge(a, b);
    }
  }
}

/// Pairs of regions, each once; some regions are neighbors of most.
std::vector<std::pair<Region, Region>> random_pairs(std::size_t regions, std::size_t hubs, std::mt19937& random)
{
  std::set<std::pair<Region, Region>> pairs;
  for (std::size_t i = 0; i < 3 * regions; ++i) {
    const Region a = random() % regions, b = random() % (random() % 2 ? hubs : regions);
    if (a != b)
      pairs.insert({(std::min)(a, b), (std::max)(a, b)});
  }
  std::vector<std::pair<Region, Region>> result(pairs.begin(), pairs.end());
  std::shuffle(result.begin(), result.end(), random);
  return result;
}

TEST(Region_adjacency_graph_test, agrees_with_maps_where_some_regions_have_very_many_sections)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::size_t n = 250;
    Graph g;
    Oracle oracle;
    for (Region r = 0; r < n; ++r)
      oracle.area[g.add_region(region(r))] = r;
    for (const auto& [a, b] : random_pairs(n, 3, random)) {
      g.add_section(a, b, section(a + b));
      oracle.sections[{a, b}] = {double(a + b), 1, true};
    }
    EXPECT_GT(degree(0, g), 64u);
    while (!oracle.sections.empty()) {
      // Among the hubs, or any.
      auto way = oracle.sections.begin();
      if (random() % 20)
        std::advance(way, random() % oracle.sections.size());
      const auto [a, b] = way->first;
      g.merge(*g.section(b, a));
      oracle.merge(a, b);
      if (oracle.area.size() % 16 == 0 || oracle.sections.size() < 16) {
        ASSERT_NO_FATAL_FAILURE(expect_equal(g, oracle));
      }
    }
  }
}

std::vector<std::uint32_t> halves_in_order(const Graph& g)
{
  std::vector<std::uint32_t> result;
  for (auto [r, last] = vertices(g); r != last; ++r)
    for (Section s : g.sections(*r))
      result.push_back(s.half());
  return result;
}

TEST(Region_adjacency_graph_test, sections_added_at_once_are_those_added_one_by_one)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::size_t n = 2 + random() % 200;
    const auto pairs = random_pairs(n, 2, random);
    Graph slow, fast;
    for (std::size_t r = 0; r < n; ++r) {
      slow.add_region(region(1));
      fast.add_region(region(1));
    }
    for (const auto& [a, b] : pairs)
      slow.add_section(a, b, section(1));
    fast.add_sections(pairs);
    for (auto [it, end] = edges(fast); it != end; ++it)
      fast[*it] = section(1);
    while (true) {
      ASSERT_EQ(halves_in_order(fast), halves_in_order(slow));
      ASSERT_EQ(fast.number_of_sections(), slow.number_of_sections());
      if (fast.number_of_sections() == 0)
        break;
      const Section s = *std::next(edges(fast).first, random() % fast.number_of_sections());
      ASSERT_EQ(fast[s].length, slow[s].length);
      ASSERT_EQ(fast.merge(s).kept, slow.merge(s).kept);
    }
  }
}

// What is quadratic here takes hours.
TEST(Region_adjacency_graph_test, hubs_take_in_a_hundred_thousand_neighbors)
{
  const Region n = 100000;
  Graph g;
  for (Region r = 0; r < n; ++r)
    g.add_region(region(1));
  for (Region r = 2; r < n; ++r) {
    g.add_section(0, r, section(1));
    g.add_section(1, r, section(1));
  }
  for (Region r = 2; r < n; ++r) {
    g.merge(*g.section(r % 2, r));
    ASSERT_TRUE(g.section(0, 1));
  }
  EXPECT_EQ(g.number_of_sections(), 1u);
  EXPECT_EQ(g[*g.section(1, 0)].length, double(n - 2));
  EXPECT_EQ(g[0].area + g[1].area, double(n));
}

// build_region_adjacency_graph()

template <typename Parameters>
Graph build(const Soup& soup, const Labels& labels, const Parameters& np)
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  auto map = face_map(mesh);
  std::size_t i = 0;
  for (auto f : faces(mesh))
    put(map, f, labels[i++]);
  return RS::build_region_adjacency_graph(mesh, map, np);
}

TEST(Build_region_adjacency_graph_test, a_cube_of_six_regions)
{
  const Graph g = build(cube(), {0, 1, 2, 3, 4, 5}, RS::parameters::default_values());
  EXPECT_EQ(g.number_of_regions(), 6u);
  EXPECT_EQ(g.number_of_sections(), 12u);
  for (Region r = 0; r < 6; ++r) {
    EXPECT_EQ(g[r].area, 1);
    EXPECT_EQ(g[r].perimeter, 4);
    EXPECT_EQ(degree(r, g), 4u);
    EXPECT_FALSE(g.section(r, r ^ 1)) << "opposite faces";
  }
  EXPECT_EQ(g[*g.section(0, 2)].length, 1);
  EXPECT_NEAR(g[*g.section(0, 2)].mean_angle(), std::acos(-1.0) / 2, 1e-15);
}

TEST(Build_region_adjacency_graph_test, borders_of_the_mesh_are_no_perimeter)
{
  //      +--+--+
  //      |1 |2 |     ids of any order
  //      +--+--+
  //      |0 |1 |
  //      +--+--+
  const Graph g = build(grid(2, 2), {0, 1, 1, 2}, RS::parameters::default_values());
  EXPECT_EQ(g.number_of_sections(), 2u);
  EXPECT_EQ(g[0].perimeter, 2);
  EXPECT_EQ(g[1].perimeter, 4);
  EXPECT_EQ(g[1].area, 2);
  const auto& between = g[*g.section(0, 1)];
  EXPECT_EQ(between.length, 2);
  EXPECT_EQ(between.number_of_edges, 2u);
  EXPECT_EQ(between.mean_angle(), std::acos(-1.0)); // flat
}

TEST(Build_region_adjacency_graph_test, edges_of_degenerate_faces_count_as_flat)
{
  // The cap is a region of its own, its neighbors are folded up by a right angle.
  Soup soup = cap();
  soup.points[3] = {1, 0, 1};
  const Graph g = build(soup, {0, 1, 1, 2}, RS::parameters::default_values());
  EXPECT_EQ(g[0].area, 0);
  EXPECT_EQ(g[0].perimeter, 4);
  EXPECT_EQ(g[*g.section(0, 1)].mean_angle(), std::acos(-1.0));
  EXPECT_EQ(g[*g.section(0, 2)].mean_angle(), std::acos(-1.0));
}

TEST(Build_region_adjacency_graph_test, constrained_sections_are_not_mergeable)
{
  const Soup soup = grid(2, 2); // vertices in rows of three; 1-4 is between the faces 0 and 1
  const Surface_mesh mesh = to_surface_mesh(soup);
  const Graph g =
      build(soup, {0, 1, 2, 3},
            RS::parameters::edge_is_constrained_map(edge_map(mesh, std::set<Edge>{{1, 4}})));
  EXPECT_FALSE(g.is_mergeable(*g.section(0, 1)));
  EXPECT_TRUE(g.is_mergeable(*g.section(0, 2)));
  EXPECT_EQ(g.number_of_sections(), 4u);
}

TEST(Build_region_adjacency_graph_test, regions_may_be_scattered)
{
  const Graph g = build(grid(4, 1), {0, 1, 0, 1}, RS::parameters::default_values());
  EXPECT_EQ(g.number_of_sections(), 1u);
  EXPECT_EQ(g[0].perimeter, 3);
  EXPECT_EQ(g[*g.section(0, 1)].number_of_edges, 3u);
}

TEST(Build_region_adjacency_graph_test, merged_data_is_that_of_the_merged_labels)
{
  for (Family family : all_families)
    for (unsigned seed = 0; seed < 8; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const Soup soup = random_mesh(family, seed);
      const Result result = run(soup, Options(3, reference::Convexity::all));
      Graph merged = build(soup, result.regions, RS::parameters::default_values());
      std::map<std::size_t, Region> region_of_segment;
      for (const auto& m : result.tree.merges())
        merged.merge(*merged.section(m.kept, m.removed));
      for (std::size_t f = 0; f < soup.polygons.size(); ++f)
        region_of_segment.emplace(result.segments[f], Region(result.regions[f]));
      const Graph fresh = build(soup, result.segments, RS::parameters::default_values());
      ASSERT_EQ(merged.number_of_regions(), fresh.number_of_regions());
      ASSERT_EQ(merged.number_of_sections(), fresh.number_of_sections());
      for (const auto& [s, r] : region_of_segment) {
        EXPECT_NEAR(merged[r].area, fresh[Region(s)].area, 1e-9);
        EXPECT_NEAR(merged[r].perimeter, fresh[Region(s)].perimeter, 1e-9);
      }
    }
}

} // namespace
