// SPDX-License-Identifier: GPL-3.0-or-later

// Models of the concepts that have the required members and nothing more: no copy where none is
// asked for, no default constructor, no comparison. What compiles and runs here is what the
// concepts ask for.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/region_segmentation.h>

#include <gtest/gtest.h>

namespace {

namespace RS = CGAL::Region_segmentation;
namespace RP = CGAL::Region_segmentation::parameters;

struct Region_data_archetype
{
  Region_data_archetype() = default;
  Region_data_archetype(const Region_data_archetype&) = default;
  Region_data_archetype& operator=(const Region_data_archetype&) = delete;

  void add_face(const RS::Flat_mesh&, std::size_t) { ++faces; }
  void add_border_edge(const RS::Flat_mesh&, std::size_t, std::size_t) { ++border_edges; }
  template <typename Section>
  void absorb(const Region_data_archetype& other, const Section& between)
  {
    faces += other.faces;
    border_edges += other.border_edges - 2 * between.edges;
  }

  std::size_t faces = 0, border_edges = 0;
};

struct Section_data_archetype
{
  Section_data_archetype() = default;
  Section_data_archetype(const Section_data_archetype&) = default;
  Section_data_archetype& operator=(const Section_data_archetype&) = delete;

  void add_edge(const RS::Flat_mesh&, std::size_t, std::size_t) { ++edges; }
  void absorb(const Section_data_archetype& other) { edges += other.edges; }

  std::size_t edges = 0;
};

using Graph = RS::Region_adjacency_graph<Region_data_archetype, Section_data_archetype>;

class Region_initializer_archetype
{
public:
  explicit Region_initializer_archetype(int) {}
  Region_initializer_archetype(const Region_initializer_archetype&) = default;
  Region_initializer_archetype& operator=(const Region_initializer_archetype&) = delete;

  RS::Region_labels operator()(const RS::Flat_mesh& flat, const RS::Edge_marks&) const
  {
    RS::Region_labels labels;
    labels.number_of_regions = flat.number_of_faces();
    for (std::size_t f = 0; f < flat.number_of_faces(); ++f)
      labels.of_face.push_back(RS::Flat_mesh::Index(f));
    return labels;
  }
};

class Section_cost_archetype
{
public:
  explicit Section_cost_archetype(int) {}
  Section_cost_archetype(const Section_cost_archetype&) = default;
  Section_cost_archetype& operator=(const Section_cost_archetype&) = delete;

  double operator()(const Graph& g, Graph::section_descriptor s) const
  {
    return -double(g[s].edges);
  }
};

class Policy_archetype
{
public:
  using RegionData = Region_data_archetype;
  using SectionData = Section_data_archetype;

  explicit Policy_archetype(int) {}
  Policy_archetype(const Policy_archetype&) = default;
  Policy_archetype& operator=(const Policy_archetype&) = delete;

  void initialize(const Graph&, std::size_t) {}
  std::optional<RS::Merge_candidate> next(const Graph& g)
  {
    const auto range = edges(g);
    if (range.first == range.second)
      return std::nullopt;
    return RS::Merge_candidate{*range.first, 0};
  }
  void on_merge(const Graph&, const Graph::Merge&) {}
};

class Stop_archetype
{
public:
  explicit Stop_archetype(int) {}
  Stop_archetype(const Stop_archetype&) = default;
  Stop_archetype& operator=(const Stop_archetype&) = delete;

  bool operator()(const Graph& g, double) { return g.number_of_regions() <= 3; }
};

class Visitor_archetype
{
public:
  explicit Visitor_archetype(int) {}
  Visitor_archetype(const Visitor_archetype&) = delete;
  Visitor_archetype& operator=(const Visitor_archetype&) = delete;

  bool go_further(const char*, double) { return true; }
};

Graph graph_of_cube()
{
  const auto mesh = test::to_surface_mesh(test::cube());
  auto map = test::face_map(mesh);
  std::size_t i = 0;
  for (auto f : faces(mesh))
    put(map, f, i++);
  return RS::build_region_adjacency_graph<Graph>(mesh, map);
}

TEST(Archetypes_test, data)
{
  const Graph g = graph_of_cube();
  EXPECT_EQ(g[0].faces, 1u);
  EXPECT_EQ(g[0].border_edges, 4u);
  EXPECT_EQ(g[*g.section(0, 2)].edges, 1u);
}

TEST(Archetypes_test, policy_stop_and_visitor)
{
  Graph g = graph_of_cube();
  Policy_archetype policy(0);
  Visitor_archetype visitor(0);
  RS::merge_regions(g, policy, 2, Stop_archetype(0), RP::visitor(std::ref(visitor)));
  EXPECT_EQ(g.number_of_regions(), 3u);
  std::size_t faces = 0;
  for (auto [it, end] = vertices(g); it != end; ++it)
    faces += g[*it].faces;
  EXPECT_EQ(faces, 6u);
}

TEST(Archetypes_test, cost)
{
  Graph g = graph_of_cube();
  RS::Lowest_cost_first<Section_cost_archetype> policy(Section_cost_archetype(0));
  RS::merge_regions(g, policy, 2, RS::Stop_at_count{2});
  EXPECT_EQ(g.number_of_regions(), 2u);
}

TEST(Archetypes_test, initializer_policy_and_visitor_in_the_pipeline)
{
  const auto mesh = test::to_surface_mesh(test::cube());
  Visitor_archetype visitor(0);
  const auto result = test::run(mesh, RP::number_of_segments(2)
                                          .region_initializer(Region_initializer_archetype(0))
                                          .merging_policy(Policy_archetype(0))
                                          .visitor(std::ref(visitor)));
  EXPECT_EQ(result.number_of_segments, 2u);
  EXPECT_EQ(result.tree.number_of_regions(), 6u);
}

// A cost can name the data that it reads; the pipeline makes a graph with it.
struct Cost_with_data
{
  using RegionData = Region_data_archetype;
  using SectionData = Section_data_archetype;
  double operator()(const Graph& g, Graph::section_descriptor s) const
  {
    return double(g[s].edges);
  }
};

TEST(Archetypes_test, a_cost_that_names_its_data)
{
  using Policy = RS::Lowest_cost_first<Cost_with_data>;
  constexpr bool is_graph_of_cost =
      std::is_same<typename RS::internal::Companions_of_policy<Policy>::Graph, Graph>::value;
  EXPECT_TRUE(is_graph_of_cost);
  if constexpr (is_graph_of_cost) {
    const auto mesh = test::to_surface_mesh(test::cube());
    const auto result = test::run(mesh, RP::number_of_segments(2)
                                            .region_initializer(Region_initializer_archetype(0))
                                            .merging_policy(Policy()));
    EXPECT_EQ(result.number_of_segments, 2u);
  }
}

} // namespace
