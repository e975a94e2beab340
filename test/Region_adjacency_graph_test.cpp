// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"
#include "stages.h"

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <boost/concept/assert.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace Region_adjacency_graph_test {

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
  data.number_of_adjacencies = edges;
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

double minimum_spanning_length(const Graph& g)
{
  std::vector<Section> tree;
  boost::kruskal_minimum_spanning_tree(g, std::back_inserter(tree),
                                       boost::weight_map(get(&RS::Section_geometry::length, g)));
  double sum = 0;
  for (Section s : tree)
    sum += g[s].length;
  return sum;
}

double distance(const Graph& g, Region from, Region to)
{
  std::vector<double> distances(num_vertices(g));
  boost::dijkstra_shortest_paths(g, from,
                                 boost::weight_map(get(&RS::Section_geometry::length, g))
                                   .distance_map(boost::make_iterator_property_map(
                                     distances.begin(), get(boost::vertex_index, g))));
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

TEST(Region_adjacency_graph_test, sections_without_edges_are_mergeable_only_when_absorbed)
{
  Graph g;
  for (int i = 0; i < 4; ++i)
    g.add_region(region(1));
  g.add_section(0, 1, section(1));
  const Section b = g.add_section(2, 3, section(1)), c = g.add_section(1, 2, section(1)),
                apart = g.add_nonadjacent_section(0, 2);
  g.add_nonadjacent_section(0, 3);
  EXPECT_FALSE(g.is_mergeable(apart));
  EXPECT_FALSE(g.is_adjacent(apart));
  EXPECT_TRUE(g.is_adjacent(c));
  g.merge(b); // 2 and 3: the two sections without edges become one
  EXPECT_FALSE(g.is_mergeable(*g.section(0, 2)));
  g.merge(c); // 1 and 2: that to 0 absorbs one with edges
  EXPECT_TRUE(g.is_mergeable(*g.section(0, 1)));
  EXPECT_EQ(g.merge(*g.section(0, 1)).kept, 0u);
}

/// Data that a vector unit wants aligned.
struct alignas(64) Aligned_region : RS::Region_geometry
{
  double lanes[8] = {};

  template <typename SectionData>
  void absorb(const Aligned_region& other, const SectionData& between)
  {
    RS::Region_geometry::absorb(other, between);
  }
};

TEST(Region_adjacency_graph_test, data_is_aligned_as_it_asks_for)
{
  RS::Region_adjacency_graph<Aligned_region> g;
  for (std::size_t i = 0; i < 3000; ++i) {
    const auto r = g.add_region();
    ASSERT_EQ(reinterpret_cast<std::uintptr_t>(&g[r]) % 64, 0u);
  }
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
    ASSERT_EQ(g[s].number_of_adjacencies, data.edges);
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

/// A graph and an oracle, to which the same is done.
struct Graphs
{
  Graph graph;
  Oracle oracle;

  void add_region(double area) { oracle.area[graph.add_region(region(area))] = area; }

  void add_section(Region a, Region b, double length, bool is_mergeable)
  {
    const Section s = graph.add_section(a, b, section(length));
    ASSERT_EQ(source(s, graph), a);
    if (!is_mergeable)
      graph.forbid_merge(s);
    oracle.sections[std::minmax(a, b)] = {length, 1, is_mergeable};
  }

  void merge(Region a, Region b)
  {
    const auto merge = graph.merge(*graph.section(a, b));
    ASSERT_EQ(merge.kept, (std::min)(a, b));
    ASSERT_EQ(merge.removed, (std::max)(a, b));
    oracle.merge(a, b);
  }
};

TEST(Region_adjacency_graph_test, agrees_with_maps_over_random_merges)
{
  for (unsigned seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Graphs graphs;
    const std::size_t n = 2 + random() % 40;
    for (std::size_t r = 0; r < n; ++r)
      graphs.add_region(double(random() % 100));
    for (std::size_t i = random() % (3 * n); i > 0; --i) {
      const Region a = random() % n, b = seed % 3 ? random() % n : 0; // or a star
      if (a != b && !graphs.graph.section(a, b))
        graphs.add_section(a, b, double(random() % 100), random() % 10 != 0);
    }
    while (true) {
      ASSERT_NO_FATAL_FAILURE(expect_equal(graphs.graph, graphs.oracle));
      std::vector<std::pair<Region, Region>> ways;
      for (const auto& [pair, data] : graphs.oracle.sections)
        if (data.is_mergeable)
          ways.push_back(pair);
      if (ways.empty())
        break;
      const auto [a, b] = ways[random() % ways.size()];
      random() % 2 ? graphs.merge(a, b) : graphs.merge(b, a);
    }
  }
}

TEST(Region_adjacency_graph_test, agrees_with_maps_where_some_regions_have_very_many_sections)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::size_t n = 600, hubs = 3;
    Graphs graphs;
    for (Region r = 0; r < n; ++r)
      graphs.add_region(r);
    for (std::size_t i = 0; i < 3 * n; ++i) {
      const Region a = random() % n, b = random() % (random() % 2 ? hubs : n);
      if (a != b && !graphs.graph.section(a, b))
        graphs.add_section(a, b, a + b, true);
    }
    EXPECT_GT(degree(0, graphs.graph), 150u);
    const auto& sections = graphs.oracle.sections;
    while (!sections.empty()) {
      // Among the hubs, or any.
      const auto way = std::next(sections.begin(),
                                 random() % 20 ? std::ptrdiff_t(random() % sections.size()) : 0);
      const auto [a, b] = way->first;
      graphs.merge(b, a);
      if (graphs.oracle.area.size() % 16 == 0 || sections.size() < 16) {
        ASSERT_NO_FATAL_FAILURE(expect_equal(graphs.graph, graphs.oracle));
      }
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

TEST(Region_adjacency_graph_test, a_copy_of_a_merged_hub_takes_in_another_one)
{
  // Two hubs, 0 and 151, of 150 and 55 neighbors; most of those of the first are merged with each
  // other.
  Graph g;
  for (Region r = 0; r < 207; ++r)
    g.add_region(region(1));
  for (Region r = 1; r < 207; ++r)
    g.add_section(r > 151 ? 151 : 0, r, section(1));
  for (Region r = 1; r < 150; ++r)
    g.add_section(r, r + 1, section(1));
  for (Region r = 150; r > 60; --r)
    g.merge(*g.section(r - 1, r));
  Graph copy = g;
  copy.merge(*copy.section(0, 151));
  EXPECT_EQ(degree(0, copy), 60u + 55u);
  for (Region r = 1; r < 207; ++r)
    if (r <= 60 || r > 151) {
      EXPECT_TRUE(copy.section(0, r)) << r;
    }
}

// build_region_adjacency_graph()

Graph build(const Soup& soup, const Labels& labels)
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  return test::build_region_adjacency_graph(mesh, face_labels(mesh, labels));
}

TEST(Build_region_adjacency_graph_test, borders_of_the_mesh_are_no_perimeter)
{
  //      +--+--+
  //      |1 |2 |     ids of any order
  //      +--+--+
  //      |0 |1 |
  //      +--+--+
  const Graph g = build(grid(2, 2), {0, 1, 1, 2});
  EXPECT_EQ(g.number_of_sections(), 2u);
  EXPECT_EQ(g[0].perimeter, 2);
  EXPECT_EQ(g[1].perimeter, 4);
  EXPECT_EQ(g[1].area, 2);
  const auto& between = g[*g.section(0, 1)];
  EXPECT_EQ(between.length, 2);
  EXPECT_EQ(between.number_of_adjacencies, 2u);
  EXPECT_EQ(between.mean_angle(), std::acos(-1.0)); // flat
}

TEST(Build_region_adjacency_graph_test, a_partition_of_other_faces_is_refused)
{
  const RS::Surface surface = RS::make_surface(to_surface_mesh(cube()));
  EXPECT_THROW(
    RS::build_region_adjacency_graph(surface, RS::Partition::from_labels(std::vector<int>(5))),
    RS::Invalid_method);
}

TEST(Build_region_adjacency_graph_test, merged_data_is_that_of_the_merged_labels)
{
  for_each_random_mesh(all_families, 8, [&](const Soup& soup, unsigned) {
    const Result result = run(soup, Options(3, reference::Convexity::all));
    Graph merged = build(soup, result.regions);
    std::map<std::size_t, Region> region_of_segment;
    for (const auto& m : result.tree.merges())
      merged.merge(*merged.section(m.kept, m.removed));
    for (std::size_t f = 0; f < soup.polygons.size(); ++f)
      region_of_segment.emplace(result.segments[f], Region(result.regions[f]));
    const Graph fresh = build(soup, result.segments);
    ASSERT_EQ(merged.number_of_regions(), fresh.number_of_regions());
    ASSERT_EQ(merged.number_of_sections(), fresh.number_of_sections());
    for (const auto& [s, r] : region_of_segment) {
      EXPECT_NEAR(merged[r].area, fresh[Region(s)].area, 1e-9);
      EXPECT_NEAR(merged[r].perimeter, fresh[Region(s)].perimeter, 1e-9);
    }
  });
}

} // namespace Region_adjacency_graph_test
