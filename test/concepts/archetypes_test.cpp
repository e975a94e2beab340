// SPDX-License-Identifier: GPL-3.0-or-later

// Models of the concepts that have the required members and nothing more: no copy where none is
// asked for, no default constructor, no comparison. What compiles and runs here is what the
// concepts ask for.

#include "meshes.h"
#include "oracles.h"
#include "stages.h"

#include <CGAL/region_segmentation.h>
#include <CGAL/region_segmentation_stages.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace archetypes_test {

namespace RS = CGAL::Region_segmentation;
namespace RP = CGAL::Region_segmentation::parameters;

struct Region_data_archetype
{
  Region_data_archetype() = default;
  Region_data_archetype(const Region_data_archetype&) = default;
  Region_data_archetype& operator=(const Region_data_archetype&) = delete;

  void add_face(const RS::Surface&, std::size_t) { ++faces; }
  void add_border(const RS::Surface&, std::size_t) { ++borders; }
  template <typename Section>
  void absorb(const Region_data_archetype& other, const Section& between)
  {
    faces += other.faces;
    borders += other.borders - 2 * between.adjacencies;
  }

  std::size_t faces = 0, borders = 0;
};

struct Section_data_archetype
{
  Section_data_archetype() = default;
  Section_data_archetype(const Section_data_archetype&) = default;
  Section_data_archetype& operator=(const Section_data_archetype&) = delete;

  void add_adjacency(const RS::Surface&, std::size_t) { ++adjacencies; }
  void absorb(const Section_data_archetype& other) { adjacencies += other.adjacencies; }

  std::size_t adjacencies = 0;
};

using Graph = RS::Region_adjacency_graph<Region_data_archetype, Section_data_archetype>;

class Annotator_archetype
{
public:
  using RegionData = Region_data_archetype;
  using SectionData = Section_data_archetype;

  explicit Annotator_archetype(int) {}
  Annotator_archetype(const Annotator_archetype&) = default;
  Annotator_archetype& operator=(const Annotator_archetype&) = delete;

  void operator()(Graph& graph, const RS::Surface& surface, const RS::Partition& regions,
                  const RS::Region_rays& rays) const
  {
    EXPECT_EQ(graph.number_of_regions(), regions.number_of_parts());
    EXPECT_EQ(regions.size(), surface.number_of_faces());
    EXPECT_EQ(rays.shapes.regions.size(), regions.number_of_parts());
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
    return -double(g[s].adjacencies);
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

class Number_chooser_archetype
{
public:
  explicit Number_chooser_archetype(int) {}
  Number_chooser_archetype(const Number_chooser_archetype&) = default;
  Number_chooser_archetype& operator=(const Number_chooser_archetype&) = delete;

  std::size_t operator()(const RS::Merge_tree& tree, const RS::Surface& surface) const
  {
    EXPECT_EQ(surface.number_of_faces(), 6u);
    return tree.number_of_regions() / 2;
  }
};

class Visitor_archetype
{
public:
  explicit Visitor_archetype(int) {}
  Visitor_archetype(const Visitor_archetype&) = delete;
  Visitor_archetype& operator=(const Visitor_archetype&) = delete;

  bool on_progress(const char*, double) { return true; }
};

/// What a method prepares is neither copied nor moved.
class Prepared_archetype
{
public:
  explicit Prepared_archetype(std::size_t faces)
    : m_faces(faces)
  {}
  Prepared_archetype(const Prepared_archetype&) = delete;
  Prepared_archetype& operator=(const Prepared_archetype&) = delete;

  /// Every face is a region.
  RS::Partition regions() const { return RS::Partition::into_single_elements(m_faces); }

private:
  std::size_t m_faces;
};

/// A method with one order of merges for all numbers: each region is merged with the first one.
class Method_archetype
{
public:
  explicit Method_archetype(int) {}
  Method_archetype(const Method_archetype&) = default;
  Method_archetype& operator=(const Method_archetype&) = delete;

  Prepared_archetype prepare(const RS::Surface& surface, std::size_t,
                             const RS::Execution& execution) const
  {
    execution.stage("regions").report(0.5);
    return Prepared_archetype(surface.number_of_faces());
  }

  RS::Hierarchy merge(const RS::Surface& surface, const Prepared_archetype& prepared,
                      const RS::Request& request, const RS::Execution& execution) const
  {
    execution.stage("merging");
    RS::Requested_regions requested = RS::requested_regions(surface, prepared.regions(),
                                                            request.seeds);
    RS::Merge_tree tree(requested.regions.number_of_parts());
    bool is_constrained = false;
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
      is_constrained |= surface.has_flag(a, RS::Surface::CONSTRAINED);
    for (std::uint32_t r = 1; r < tree.number_of_regions() && !is_constrained; ++r)
      tree.push_back({0, r, double(r)});
    const std::size_t number = request.number_of_segments > 0 ? request.number_of_segments : 3;
    return RS::Hierarchy(std::move(requested.regions), std::move(tree), number);
  }
};

/// A method whose merges depend on the number: the first region, and the others.
class Method_for_number_archetype
{
public:
  explicit Method_for_number_archetype(int) {}
  Method_for_number_archetype(const Method_for_number_archetype&) = default;
  Method_for_number_archetype& operator=(const Method_for_number_archetype&) = delete;

  Prepared_archetype prepare(const RS::Surface& surface, std::size_t number_of_segments,
                             const RS::Execution&) const
  {
    EXPECT_TRUE(number_of_segments == 2 || number_of_segments == 0); // 0: of a Segmenter
    return Prepared_archetype(surface.number_of_faces());
  }

  RS::Segmentation merge(const RS::Surface&, const Prepared_archetype& prepared,
                         const RS::Request& request, const RS::Execution&) const
  {
    EXPECT_EQ(request.number_of_segments, 2u);
    const RS::Partition regions = prepared.regions();
    std::vector<int> labels(regions.number_of_parts(), 1);
    labels[0] = 0;
    return {composed(regions, RS::Partition::from_labels(labels)), RS::Merge_tree(2), 2};
  }
};

Graph graph_of_cube()
{
  const auto mesh = test::to_surface_mesh(test::cube());
  return test::build_region_adjacency_graph<Region_data_archetype, Section_data_archetype>(
    mesh, test::face_labels(mesh, {0, 1, 2, 3, 4, 5}));
}

TEST(Archetypes_test, data)
{
  const Graph g = graph_of_cube();
  EXPECT_EQ(g[0].faces, 1u);
  EXPECT_EQ(g[0].borders, 4u);
  EXPECT_EQ(g[*g.section(0, 2)].adjacencies, 1u);
}

TEST(Archetypes_test, policy_and_visitor)
{
  Graph g = graph_of_cube();
  Policy_archetype policy(0);
  Visitor_archetype visitor(0);
  RS::merge_regions(g, policy, 3, RP::visitor(std::ref(visitor)));
  EXPECT_EQ(g.number_of_regions(), 3u);
  std::size_t faces = 0;
  for (auto [it, end] = vertices(g); it != end; ++it)
    faces += g[*it].faces;
  EXPECT_EQ(faces, 6u);
}

TEST(Archetypes_test, policies_one_after_the_other)
{
  Graph g = graph_of_cube();
  const Policy_archetype policy(0);
  RS::merge_regions(
    g, RS::Policy_phases<Policy_archetype, Policy_archetype>{{policy, 4}, {policy, 1}}, 2);
  EXPECT_EQ(g.number_of_regions(), 2u);
}

TEST(Archetypes_test, cost)
{
  Graph g = graph_of_cube();
  RS::Lowest_cost_first<Section_cost_archetype> policy(Section_cost_archetype(0));
  RS::merge_regions(g, policy, 2);
  EXPECT_EQ(g.number_of_regions(), 2u);
}

/// What segment() and a segmenter do with a method that gives one tree, and three segments of a
/// cube.
template <typename Method>
void use_method(const Method& method)
{
  const auto mesh = test::to_surface_mesh(test::cube());
  Visitor_archetype visitor(0);
  const auto result = test::run(
    mesh, RP::number_of_segments(2).method(method).visitor(std::ref(visitor)));
  EXPECT_EQ(result.number_of_segments, 2u);
  EXPECT_EQ(result.tree.number_of_regions(), 6u);
  EXPECT_EQ(test::run(mesh, RP::method(method)).number_of_segments, 3u) << "chosen";

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

TEST(Archetypes_test, method)
{
  use_method(Method_archetype(0));
}

TEST(Archetypes_test, parts_of_superfacet_merging)
{
  use_method(RS::Superfacet_merging{Annotator_archetype(0), Policy_archetype(0),
                                    Number_chooser_archetype(0)});
}

TEST(Archetypes_test, method_whose_merges_depend_on_the_number)
{
  const auto mesh = test::to_surface_mesh(test::cube());
  const auto np = RP::method(Method_for_number_archetype(0));
  EXPECT_EQ(test::segments_of(mesh, np.number_of_segments(2)), (test::Labels{0, 1, 1, 1, 1, 1}));
  const RS::Segmenter segmenter(mesh, np);
  auto map = test::face_map(mesh);
  EXPECT_EQ(segmenter.segment(map, 2), 2u);
  EXPECT_EQ(test::labels_of(mesh, map), (test::Labels{0, 1, 1, 1, 1, 1}));
}

// A cost can name the data that it reads; the graph must have them.
struct Cost_with_data
{
  using RegionData = Region_data_archetype;
  using SectionData = Section_data_archetype;
  double operator()(const Graph& g, Graph::section_descriptor s) const
  {
    return double(g[s].adjacencies);
  }
};

TEST(Archetypes_test, a_cost_that_names_its_data)
{
  EXPECT_TRUE((RS::internal::reads_data_of<Cost_with_data, Graph>()));
  EXPECT_FALSE((RS::internal::reads_data_of<Cost_with_data, RS::Region_adjacency_graph<>>()));
  Graph g = graph_of_cube();
  RS::merge_regions(g, RS::Lowest_cost_first<Cost_with_data>(), 2);
  EXPECT_EQ(g.number_of_regions(), 2u);
}

// What the types of a method cannot tell is an exception.

/// Its regions are those of a mesh of two faces.
struct Method_of_two_faces
{
  int prepare(const RS::Surface&, std::size_t, const RS::Execution&) const { return 0; }
  RS::Hierarchy merge(const RS::Surface&, int, const RS::Request&, const RS::Execution&) const
  {
    return RS::Hierarchy(RS::Partition::from_labels(std::vector<int>{0, 1}), RS::Merge_tree(2), 2);
  }
};

/// Its regions are not numbered by their first faces: one does not exist, or has no face.
template <std::size_t last_number>
struct Method_of_wrong_numbers
{
  int prepare(const RS::Surface&, std::size_t, const RS::Execution&) const { return 0; }
  RS::Hierarchy merge(const RS::Surface& surface, int, const RS::Request& request,
                      const RS::Execution&) const
  {
    RS::Partition::Numbers numbers(surface.number_of_faces(), 0);
    numbers.back() = last_number;
    RS::Partition regions(std::move(numbers), 2);
    if (request.number_of_segments == 3) {
      regions = RS::requested_regions(surface, regions, request.seeds).regions;
      RS::build_region_adjacency_graph(surface, regions);
    }
    return RS::Hierarchy(regions, RS::Merge_tree(2), 2);
  }
};

/// Its merges are not those of its regions.
struct Method_of_other_merges
{
  int prepare(const RS::Surface&, std::size_t, const RS::Execution&) const { return 0; }
  RS::Segmentation merge(const RS::Surface& surface, int, const RS::Request&,
                         const RS::Execution&) const
  {
    return {RS::Partition::from_labels(std::vector<int>(surface.number_of_faces())),
            RS::Merge_tree(2), 2};
  }
};

TEST(Archetypes_test, methods_that_break_their_promise)
{
  const auto mesh = test::to_surface_mesh(test::cube());
  auto map = test::face_map(mesh, 77);
  EXPECT_THROW(RS::segment(mesh, map, RP::number_of_segments(2).method(Method_of_two_faces())),
               RS::Invalid_method);
  EXPECT_THROW(RS::segment(mesh, map, RP::number_of_segments(2).method(Method_of_other_merges())),
               RS::Invalid_method);
#ifdef NDEBUG // else it is a precondition of Partition
  for (int k : {2, 3}) {
    EXPECT_THROW(
      RS::segment(mesh, map,
                  RP::number_of_segments(k).method(Method_of_wrong_numbers<100000000>())),
      RS::Invalid_method);
    EXPECT_THROW(
      RS::segment(mesh, map, RP::number_of_segments(k).method(Method_of_wrong_numbers<0>())),
      RS::Invalid_method);
  }
#endif
  EXPECT_THROW(RS::Segmenter(mesh, RP::method(Method_of_two_faces())), RS::Invalid_method);
  const RS::Segmenter of_other_merges(mesh, RP::method(Method_of_other_merges()));
  EXPECT_THROW(of_other_merges.segment(map, 2), RS::Invalid_method);
  EXPECT_EQ(test::labels_of(mesh, map), test::Labels(6, 77));
}

} // namespace archetypes_test
