// SPDX-License-Identifier: GPL-3.0-or-later

// Methods and parts of them as users write them, with public headers alone, on three mesh types.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/region_segmentation.h>
#include <CGAL/region_segmentation_stages.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace User_parts_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;

/// The largest deviation of the edges of a section.
struct Sharpest_section : RS::Section_geometry
{
  double sharpest = 0; // radian

  void add_adjacency(const RS::Surface& surface, std::size_t adjacency)
  {
    RS::Section_geometry::add_adjacency(surface, adjacency);
    sharpest = std::max(sharpest, surface.deviation(adjacency));
  }
  void absorb(const Sharpest_section& other)
  {
    RS::Section_geometry::absorb(other);
    sharpest = std::max(sharpest, other.sharpest);
  }
};

struct Sharpest_cost
{
  using RegionData = RS::Region_geometry;
  using SectionData = Sharpest_section;

  template <typename Graph>
  void annotate(Graph&, const RS::Surface&, const RS::Partition&) const
  {}

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    return graph[s].sharpest;
  }
};

/// Merges faces at the lowest cost first, with the data that the cost names: a method with one tree
/// for all numbers.
template <typename Cost>
struct Merging_of_faces
{
  Cost cost;

  struct Prepared
  {};

  Prepared prepare(const RS::Surface&, std::size_t, const RS::Execution&) const { return {}; }

  RS::Hierarchy merge(const RS::Surface& surface, const Prepared&, const RS::Request& request,
                      const RS::Execution&) const
  {
    const RS::Partition faces = RS::Partition::into_single_elements(surface.number_of_faces());
    RS::Requested_regions requested = RS::requested_regions(surface, faces, request.seeds);
    auto graph = RS::build_region_adjacency_graph<typename Cost::RegionData,
                                                  typename Cost::SectionData>(surface,
                                                                              requested.regions);
    cost.annotate(graph, surface, requested.regions);
    RS::Merge_tree tree = RS::merge_regions(graph, RS::Lowest_cost_first<Cost>(cost), 1);
    return RS::Hierarchy(std::move(requested.regions), std::move(tree),
                         request.number_of_segments > 0 ? request.number_of_segments : 1);
  }
};

TEST(User_parts_test, a_cost_on_a_datum)
{
  // A box on a plate: merging the least sharp first leaves the concave line and the creases for
  // last.
  const Surface_mesh mesh = to_surface_mesh(triangulated(box_on_plate()));
  const RS::Segmenter segmenter(mesh, RS::parameters::method(Merging_of_faces<Sharpest_cost>()));
  for (const auto& merge : segmenter.merge_tree().merges())
    EXPECT_TRUE(std::abs(merge.cost) < 1e-9 || std::abs(merge.cost - CGAL_PI / 2) < 1e-9)
      << merge.cost;
  const RS::Partition flats = segmenter.merge_tree().partition_at_cost(0.1);
  EXPECT_EQ(flats.number_of_parts(), 11u) << "the flat faces: 5 of the box and 6 of the plate";
}

/// Scales the visibility of the annotator it derives from: a constant of the user's.
struct Weak_visibility : RS::Visibility_annotator
{
  double factor = 1;

  template <typename Graph>
  void operator()(Graph& graph, const RS::Surface& surface, const RS::Partition& regions,
                  const RS::Region_rays& rays) const
  {
    RS::Visibility_annotator::operator()(graph, surface, regions, rays);
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      graph[*range.first].visibility *= factor;
  }
};

TEST(User_parts_test, constants_of_an_annotator)
{
  const Surface_mesh mesh = to_surface_mesh(random_mesh(Family::TORUS, 3));
  Weak_visibility annotator;
  const auto costs = [&](double factor) {
    annotator.factor = factor;
    const RS::Superfacet_merging method{annotator, RS::Visibility_merging().policy,
                                        RS::Visibility_merging().chooser};
    const RS::Segmenter segmenter(mesh, RS::parameters::method(method));
    std::vector<double> result;
    for (const auto& merge : segmenter.merge_tree().merges())
      result.push_back(merge.cost);
    return result;
  };
  const RS::Segmenter visibility(mesh, RS::parameters::method(RS::Visibility_merging()));
  std::vector<double> expected;
  for (const auto& merge : visibility.merge_tree().merges())
    expected.push_back(merge.cost);
  EXPECT_EQ(costs(1), expected);
  EXPECT_NE(costs(0.5), expected);
}

/// A third of the first regions.
struct A_third
{
  std::size_t operator()(const RS::Merge_tree& tree, const RS::Surface&) const
  {
    return tree.number_of_regions() / 3;
  }
};

TEST(User_parts_test, a_number_chooser)
{
  const Surface_mesh mesh = to_surface_mesh(sphere(3));
  RS::Superfacet_merging method{RS::Visibility_annotator(), RS::Visibility_merging().policy,
                                A_third()};
  method.superfacets.number = 60;
  method.number_of_draws = 1;
  auto map = face_map(mesh);
  EXPECT_EQ(RS::segment(mesh, map, RS::parameters::method(method)), 20u);
}

TEST(User_parts_test, a_method_is_used_again)
{
  // Every run copies the policy, so nothing of one mesh is left for the next.
  const RS::Superfacet_merging method{RS::Visibility_annotator(),
                                      RS::Lowest_cost_first<RS::Visibility_cost>(),
                                      RS::Number_from_costs(-19.5)};
  for (Family family : {Family::BLOCKS, Family::SPHERE, Family::TORUS, Family::BLOCKS}) {
    const Surface_mesh mesh = to_surface_mesh(random_mesh(family, 1));
    auto first = face_map(mesh), again = face_map(mesh);
    RS::segment(mesh, first, RS::parameters::number_of_segments(3).method(method));
    RS::segment(mesh, again, RS::parameters::number_of_segments(3).method(method));
    EXPECT_EQ(labels_of(mesh, first), labels_of(mesh, again));
  }
}

} // namespace User_parts_test
