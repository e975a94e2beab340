// SPDX-License-Identifier: GPL-3.0-or-later

// A scalar of the faces in the cost: Scalar_annotator and Scalar_cost.

#include "meshes.h"

#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/merge_regions.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Scalar_cost.h>
#include <CGAL/Region_segmentation/Superfacets/Superfacet_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace Scalar_cost_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;
using Merges = std::vector<RS::Merge_tree::Merge>;

/// Nothing but the data that a scalar is added to.
struct No_annotator
{
  using RegionData = RS::Region_geometry;
  using SectionData = RS::Section_geometry;

  template <typename Graph>
  void operator()(Graph&, const RS::Surface&, const RS::Partition&) const
  {}
};

struct No_cost
{
  using RegionData = RS::Region_geometry;
  using SectionData = RS::Section_geometry;

  template <typename Graph>
  double operator()(const Graph&, typename Graph::section_descriptor) const
  {
    return 0;
  }
};

using Annotator = RS::Scalar_annotator<No_annotator>;

auto annotated(const RS::Surface& surface, const RS::Partition& regions, const Annotator& annotator)
{
  auto graph = RS::build_region_adjacency_graph<Annotator::RegionData, Annotator::SectionData>(
    surface, regions);
  annotator(graph, surface, regions);
  return graph;
}

std::vector<double> random_values(std::size_t number)
{
  const unsigned seed = std::random_device()();
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  std::vector<double> values;
  for (std::size_t i = 0; i < number; ++i)
    values.push_back(std::uniform_real_distribution<double>(-3, 3)(random));
  return values;
}

/// The lowest difference of means between regions with a common edge: from the faces, by CGAL's
/// areas.
double lowest_difference(const Surface_mesh& mesh, const std::vector<double>& values,
                         const std::vector<std::size_t>& region)
{
  std::vector<double> areas(values.size()), sums(values.size());
  for (auto f : faces(mesh)) {
    const double area = CGAL::to_double(CGAL::Polygon_mesh_processing::face_area(f, mesh));
    areas[region[f]] += area;
    sums[region[f]] += area * values[f];
  }
  double lowest = std::numeric_limits<double>::infinity();
  for (auto h : halfedges(mesh)) {
    if (is_border(edge(h, mesh), mesh))
      continue;
    const std::size_t a = region[face(h, mesh)], b = region[face(opposite(h, mesh), mesh)];
    if (a != b)
      lowest = (std::min)(lowest, std::abs(sums[a] / areas[a] - sums[b] / areas[b]));
  }
  return lowest;
}

TEST(Scalar_cost, merges_by_the_difference_of_the_means)
{
  const double weight = 2.5;
  const Surface_mesh mesh = to_surface_mesh(random_mesh(Family::SPHERE, 3));
  const std::vector<double> values = random_values(num_faces(mesh));
  const RS::Surface surface = RS::make_surface(mesh);
  auto graph = annotated(surface, RS::Partition::into_single_elements(surface.number_of_faces()),
                         Annotator(values));
  const RS::Merge_tree tree = RS::merge_regions(
    graph, RS::Lowest_cost_first(RS::Scalar_cost<No_cost>(weight)), 1);
  std::vector<std::size_t> region(num_faces(mesh));
  for (std::size_t f = 0; f < region.size(); ++f)
    region[f] = f;
  ASSERT_EQ(tree.merges().size(), region.size() - 1);
  for (const auto& merge : tree.merges()) {
    ASSERT_NEAR(merge.cost, weight * lowest_difference(mesh, values, region), 1e-9);
    for (std::size_t& r : region)
      if (r == merge.removed)
        r = merge.kept;
  }
}

TEST(Scalar_cost, of_a_constant_is_that_of_the_other_cost)
{
  const Surface_mesh mesh = to_surface_mesh(random_mesh(Family::TORUS, 5));
  const auto merges = [&](const auto& annotator, const auto& policy) {
    const RS::Superfacet_merging method{annotator, policy, RS::Number_from_costs(-19.5)};
    return RS::Segmenter(mesh, RS::parameters::method(method)).merge_tree().merges();
  };
  const Merges expected = merges(RS::Visibility_annotator(),
                                 RS::Lowest_cost_first<RS::Visibility_cost>());
  const Merges merged = merges(RS::Scalar_annotator(std::vector<int>(num_faces(mesh), 7)),
                               RS::Lowest_cost_first(RS::Scalar_cost(9)));
  ASSERT_EQ(merged.size(), expected.size());
  for (std::size_t i = 0; i < merged.size(); ++i) {
    EXPECT_EQ(merged[i].kept, expected[i].kept);
    EXPECT_EQ(merged[i].removed, expected[i].removed);
    EXPECT_NEAR(merged[i].cost, expected[i].cost, 1e-9);
  }
}

/// Another method's annotator is exchanged, its costs read what they read before; seeds annotate
/// anew.
TEST(Scalar_annotator, takes_the_place_of_the_annotator_that_it_extends)
{
  const Surface_mesh mesh = to_surface_mesh(sphere(2));
  RS::Segmenter expected(mesh, RS::parameters::method(RS::Visibility_merging()));
  const RS::Scalar_annotator annotator(random_values(num_faces(mesh)));
  const RS::Visibility_merging visibility;
  const RS::Superfacet_merging method{annotator, visibility.policy, visibility.chooser};
  RS::Segmenter segmenter(mesh, RS::parameters::method(method));
  std::vector<std::size_t> seeds(num_faces(mesh), std::size_t(-1));
  seeds.front() = 0;
  seeds.back() = 1;
  const auto seed_map = boost::make_iterator_property_map(seeds.begin(),
                                                          get(boost::face_index, mesh));
  for (int round = 0; round < 2; ++round) {
    ASSERT_EQ(segmenter.merge_tree().merges().size(), expected.merge_tree().merges().size());
    for (std::size_t i = 0; i < segmenter.merge_tree().merges().size(); ++i)
      EXPECT_EQ(segmenter.merge_tree().merges()[i].cost, expected.merge_tree().merges()[i].cost);
    expected.set_seeds(seed_map);
    segmenter.set_seeds(seed_map);
  }
}

TEST(Scalar_annotator, names_values_that_are_missing_or_not_finite)
{
  const RS::Surface surface = RS::make_surface(to_surface_mesh(cube()));
  const auto message = [&](const std::vector<double>& values) -> std::string {
    try {
      annotated(surface, RS::Partition::into_single_elements(6), Annotator(values));
    } catch (const RS::Invalid_input& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(std::vector<double>(6, 1)), "");
  EXPECT_EQ(message({1, 2, 3}), "the Scalar_annotator has 3 values for 6 faces");
  EXPECT_EQ(message({1, 2, 3, std::nan(""), 5, 6}), "the scalar of face 3 is not finite");
}

} // namespace Scalar_cost_test
