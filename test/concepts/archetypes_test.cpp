// SPDX-License-Identifier: GPL-3.0-or-later

// Models of the concepts that have the required members and nothing more: no copy where none is
// asked for, no default constructor, no comparison. What compiles and runs here is what the
// concepts ask for.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/region_segmentation.h>

#include <gtest/gtest.h>

namespace archetypes_test {

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

  RS::Partition operator()(const RS::Flat_mesh& flat) const
  {
    std::vector<std::size_t> labels;
    for (std::size_t f = 0; f < flat.number_of_faces(); ++f)
      labels.push_back(f);
    return RS::Partition::from_labels(labels);
  }
};

/// Takes the optional last argument, too.
class Region_initializer_with_execution
{
public:
  explicit Region_initializer_with_execution(int) {}
  Region_initializer_with_execution(const Region_initializer_with_execution&) = default;
  Region_initializer_with_execution& operator=(const Region_initializer_with_execution&) = delete;

  template <typename ConcurrencyTag>
  RS::Partition operator()(const RS::Flat_mesh& flat, const RS::Execution<ConcurrencyTag>& execution) const
  {
    execution.report(0.5);
    return Region_initializer_archetype(0)(flat);
  }
};

class Annotator_archetype
{
public:
  using RegionData = Region_data_archetype;
  using SectionData = Section_data_archetype;

  explicit Annotator_archetype(int) {}
  Annotator_archetype(const Annotator_archetype&) = default;
  Annotator_archetype& operator=(const Annotator_archetype&) = delete;

  void operator()(Graph&, const RS::Flat_mesh&, const RS::Partition&) const {}
};

/// What an annotator keeps between two calls; it reads data that it asks for.
class Annotator_with_cache
{
public:
  using RegionData = Region_data_archetype;
  using SectionData = Section_data_archetype;
  static constexpr RS::Mesh_data required_mesh_data = RS::Mesh_data::CENTROIDS;

  class Cache
  {
  public:
    void renumber(const std::vector<std::uint32_t>& previous_of) { number_of_regions = previous_of.size(); }
    std::size_t number_of_regions = 0;
  };

  explicit Annotator_with_cache(int) {}
  Annotator_with_cache(const Annotator_with_cache&) = default;
  Annotator_with_cache& operator=(const Annotator_with_cache&) = delete;

  template <typename ConcurrencyTag>
  void operator()(Graph& graph, const RS::Flat_mesh& mesh, const RS::Partition& regions,
                  const RS::Execution<ConcurrencyTag>& execution) const
  {
    Cache cache;
    (*this)(graph, mesh, regions, execution, cache);
  }
  template <typename ConcurrencyTag>
  void operator()(Graph& graph, const RS::Flat_mesh& mesh, const RS::Partition& regions,
                  const RS::Execution<ConcurrencyTag>&, Cache& cache) const
  {
    EXPECT_TRUE(cache.number_of_regions == 0 || cache.number_of_regions == regions.number_of_parts());
    EXPECT_EQ(graph.number_of_regions(), regions.number_of_parts());
    EXPECT_NO_THROW(mesh.centroid(0));
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

/// Any section that is mergeable.
class Policy_archetype
{
public:
  explicit Policy_archetype(int) {}
  Policy_archetype(const Policy_archetype&) = default;
  Policy_archetype& operator=(const Policy_archetype&) = delete;

  void initialize(const Graph&) {}
  std::optional<RS::Merge_candidate> next(const Graph& g)
  {
    for (auto range = edges(g); range.first != range.second; ++range.first)
      if (g.is_mergeable(*range.first))
        return RS::Merge_candidate{*range.first, 0};
    return std::nullopt;
  }
  void on_merge(const Graph&, const Graph::Merge&) {}
};

/// A policy whose order depends on the number.
class Policy_for_number_archetype
{
public:
  explicit Policy_for_number_archetype(int) : m_policy(0) {}
  Policy_for_number_archetype(const Policy_for_number_archetype&) = default;
  Policy_for_number_archetype& operator=(const Policy_for_number_archetype&) = delete;

  void initialize(const Graph&, std::size_t number_of_segments) { EXPECT_GE(number_of_segments, 1u); }
  std::optional<RS::Merge_candidate> next(const Graph& g) { return m_policy.next(g); }
  void on_merge(const Graph&, const Graph::Merge&) {}

private:
  Policy_archetype m_policy;
};

class Number_chooser_archetype
{
public:
  explicit Number_chooser_archetype(int) {}
  Number_chooser_archetype(const Number_chooser_archetype&) = default;
  Number_chooser_archetype& operator=(const Number_chooser_archetype&) = delete;

  std::size_t operator()(const RS::Merge_tree& tree) const { return tree.number_of_regions() / 2; }
};

/// Two segments: the first region, and the others.
class Partitioner_archetype
{
public:
  explicit Partitioner_archetype(int) {}
  Partitioner_archetype(const Partitioner_archetype&) = default;
  Partitioner_archetype& operator=(const Partitioner_archetype&) = delete;

  RS::Partition operator()(const Graph& g, std::size_t) const
  {
    std::vector<int> labels(g.number_of_regions(), 1);
    labels[0] = 0;
    return RS::Partition::from_labels(labels);
  }
};

/// A method that is no `Segmentation_method`.
struct Method_archetype
{
  Method_archetype() = default;
  Method_archetype(const Method_archetype&) = default;
  Method_archetype& operator=(const Method_archetype&) = delete;

  Region_initializer_archetype initializer{0};
  Annotator_archetype annotator{0};
  Policy_archetype policy{0};
  Number_chooser_archetype chooser{0};
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
  return RS::build_region_adjacency_graph(mesh, map, Annotator_archetype(0));
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

TEST(Archetypes_test, method_and_visitor_in_the_pipeline)
{
  const auto mesh = test::to_surface_mesh(test::cube());
  Visitor_archetype visitor(0);
  const auto result =
      test::run(mesh, RP::number_of_segments(2).method(Method_archetype()).visitor(std::ref(visitor)));
  EXPECT_EQ(result.number_of_segments, 2u);
  EXPECT_EQ(result.tree.number_of_regions(), 6u);
  EXPECT_EQ(test::run(mesh, RP::method(Method_archetype())).number_of_segments, 3u) << "chosen";
}

/// What a segmenter does with a method that gives one tree.
template <typename Method>
void use_segmenter(const Method& method)
{
  const auto mesh = test::to_surface_mesh(test::cube());
  Visitor_archetype visitor(0);
  RS::Segmenter segmenter(mesh, RP::method(method).visitor(std::ref(visitor)));
  auto map = test::face_map(mesh);
  EXPECT_EQ(segmenter.segment(map), 3u);
  EXPECT_EQ(segmenter.segment(map, 2, RP::visitor(std::ref(visitor))), 2u);
  EXPECT_EQ(segmenter.merge_tree().number_of_regions(), 6u);
  segmenter.add_constraints(test::edge_map(mesh, std::uint8_t(1)), RP::visitor(std::ref(visitor)));
  EXPECT_EQ(segmenter.segment(map, 1), 6u);
  segmenter.set_seeds(test::face_map(mesh, std::size_t(-1)), RP::visitor(std::ref(visitor)));
  EXPECT_EQ(segmenter.segment(map, 1), 6u);
}

TEST(Archetypes_test, method_in_a_segmenter)
{
  use_segmenter(Method_archetype());
  use_segmenter(RS::make_segmentation_method(Region_initializer_with_execution(0), Annotator_with_cache(0),
                                             Policy_archetype(0), Number_chooser_archetype(0)));
}

TEST(Archetypes_test, policy_whose_order_depends_on_the_number)
{
  const auto mesh = test::to_surface_mesh(test::cube());
  const auto method = RS::make_segmentation_method(Region_initializer_with_execution(0), Annotator_with_cache(0),
                                                   Policy_for_number_archetype(0));
  EXPECT_EQ(test::run(mesh, RP::number_of_segments(2).method(method)).number_of_segments, 2u);
  const RS::Segmenter segmenter(mesh, RP::method(method));
  auto map = test::face_map(mesh);
  EXPECT_EQ(segmenter.segment(map, 4), 4u);
}

TEST(Archetypes_test, partitioner)
{
  const auto mesh = test::to_surface_mesh(test::cube());
  const auto method = RS::make_partitioning_method(Region_initializer_archetype(0), Annotator_archetype(0),
                                                   Partitioner_archetype(0));
  EXPECT_EQ(test::segments_of(mesh, RP::number_of_segments(2).method(method)), (test::Labels{0, 1, 1, 1, 1, 1}));
  const RS::Segmenter segmenter(mesh, RP::method(method));
  auto map = test::face_map(mesh);
  EXPECT_EQ(segmenter.segment(map, 2), 2u);
}

TEST(Archetypes_test, parts_are_exchanged_one_by_one)
{
  const auto mesh = test::to_surface_mesh(test::cube());
  const auto method = RS::Two_step()
                          .with_initializer(Region_initializer_archetype(0))
                          .with_annotator(Annotator_archetype(0))
                          .with_policy(Policy_archetype(0))
                          .with_chooser(Number_chooser_archetype(0));
  EXPECT_EQ(test::run(mesh, RP::method(method)).number_of_segments, 3u);
}

// A cost can name the data that it reads; the annotator of the method must provide them.
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
  EXPECT_TRUE((std::is_same<Policy::RegionData, Region_data_archetype>::value));
  EXPECT_TRUE((RS::internal::reads_data_of<Policy, Graph>()));
  EXPECT_FALSE((RS::internal::reads_data_of<Policy, RS::Region_adjacency_graph<>>()));
  const auto mesh = test::to_surface_mesh(test::cube());
  const auto method = RS::make_segmentation_method(Region_initializer_archetype(0), Annotator_archetype(0), Policy());
  EXPECT_EQ(test::run(mesh, RP::number_of_segments(2).method(method)).number_of_segments, 2u);
}

// What the types of a part cannot tell is an exception.
struct Short_initializer
{
  RS::Partition operator()(const RS::Flat_mesh&) const { return RS::Partition::from_labels(std::vector<int>{0, 1}); }
};
struct Short_partitioner
{
  template <typename G>
  RS::Partition operator()(const G&, std::size_t) const
  {
    return RS::Partition();
  }
};
struct Reader_of_points // without required_mesh_data
{
  RS::Partition operator()(const RS::Flat_mesh& flat) const
  {
    const std::size_t label = flat.points().number_of_points();
    return RS::Partition::from_labels(std::vector<std::size_t>(flat.number_of_faces(), label));
  }
};

TEST(Archetypes_test, parts_that_break_their_promise)
{
  const auto mesh = test::to_surface_mesh(test::cube());
  auto map = test::face_map(mesh, 77);
  EXPECT_THROW(RS::segment(mesh, map, RP::number_of_segments(2).method(
                                        RS::Two_step().with_initializer(Short_initializer()))),
               RS::Invalid_method);
  EXPECT_THROW(RS::segment(mesh, map, RP::number_of_segments(2).method(
                                        RS::Two_step().with_initializer(Reader_of_points()))),
               RS::Invalid_method);
  EXPECT_THROW(RS::segment(mesh, map,
                           RP::number_of_segments(2).method(RS::make_partitioning_method(
                               RS::Region_growing(), RS::Geometry_annotator<>(), Short_partitioner()))),
               RS::Invalid_method);
  EXPECT_EQ(test::labels_of(mesh, map), test::Labels(6, 77));
}

} // namespace archetypes_test
