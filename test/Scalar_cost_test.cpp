// SPDX-License-Identifier: GPL-3.0-or-later

// A scalar of the faces in the cost: Scalar_annotator and Scalar_cost.

#include "meshes.h"

#include <CGAL/Region_segmentation/Methods/Geometry_annotator.h>
#include <CGAL/Region_segmentation/Methods/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Methods/Scalar_annotator.h>
#include <CGAL/Region_segmentation/Methods/Scalar_cost.h>
#include <CGAL/Region_segmentation/Methods/Segmentation_method.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/read_flat_mesh.h>

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

struct Each_face
{
  RS::Partition operator()(const RS::Flat_mesh& mesh) const
  {
    std::vector<std::size_t> labels;
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      labels.push_back(f);
    return RS::Partition::from_labels(labels);
  }
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

auto method_of_scalar_alone(const std::vector<double>& values, double weight)
{
  return RS::make_segmentation_method(Each_face(), RS::Scalar_annotator<RS::Geometry_annotator<>>(values),
                                      RS::Lowest_cost_first(RS::Scalar_cost<No_cost>(weight)));
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

/// The lowest difference of means between regions with a common edge: from the faces, by CGAL's areas.
double lowest_difference(const Surface_mesh& mesh, const std::vector<double>& values, const std::vector<std::size_t>& region)
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
  const RS::Segmenter segmenter(mesh, RS::parameters::method(method_of_scalar_alone(values, weight)));
  std::vector<std::size_t> region(num_faces(mesh));
  for (std::size_t f = 0; f < region.size(); ++f)
    region[f] = f;
  ASSERT_EQ(segmenter.merge_tree().merges().size(), region.size() - 1);
  for (const auto& merge : segmenter.merge_tree().merges()) {
    ASSERT_NEAR(merge.cost, weight * lowest_difference(mesh, values, region), 1e-9);
    for (std::size_t& r : region)
      if (r == merge.removed)
        r = merge.kept;
  }
}

TEST(Scalar_cost, of_a_constant_is_that_of_the_other_cost)
{
  const Surface_mesh mesh = to_surface_mesh(random_mesh(Family::TORUS, 5));
  const RS::Lowest_cost_first<RS::Visibility_cost> policy;
  const auto merges = [&](const auto& method) {
    return RS::Segmenter(mesh, RS::parameters::method(method)).merge_tree().merges();
  };
  const Merges expected =
    merges(RS::make_segmentation_method(RS::Superfacets(), RS::Visibility_annotator(), policy));
  const Merges merged = merges(RS::make_segmentation_method(
    RS::Superfacets(), RS::Scalar_annotator(std::vector<int>(num_faces(mesh), 7)), RS::Lowest_cost_first(RS::Scalar_cost(9))));
  ASSERT_EQ(merged.size(), expected.size());
  for (std::size_t i = 0; i < merged.size(); ++i) {
    EXPECT_EQ(merged[i].kept, expected[i].kept);
    EXPECT_EQ(merged[i].removed, expected[i].removed);
    EXPECT_NEAR(merged[i].cost, expected[i].cost, 1e-9);
  }
}

/// Another method's annotator is exchanged, its costs read what they read before; seeds annotate anew.
TEST(Scalar_annotator, takes_the_place_of_the_annotator_that_it_extends)
{
  const Surface_mesh mesh = to_surface_mesh(sphere(2));
  RS::Segmenter expected(mesh, RS::parameters::method(RS::Visibility_merging()));
  const RS::Scalar_annotator annotator(random_values(num_faces(mesh)));
  RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Visibility_merging().with_annotator(annotator)));
  std::vector<std::size_t> seeds(num_faces(mesh), std::size_t(-1));
  seeds.front() = 0;
  seeds.back() = 1;
  const auto seed_map = boost::make_iterator_property_map(seeds.begin(), get(boost::face_index, mesh));
  for (int round = 0; round < 2; ++round) {
    ASSERT_EQ(segmenter.merge_tree().merges().size(), expected.merge_tree().merges().size());
    for (std::size_t i = 0; i < segmenter.merge_tree().merges().size(); ++i)
      EXPECT_EQ(segmenter.merge_tree().merges()[i].cost, expected.merge_tree().merges()[i].cost);
    expected.set_seeds(seed_map);
    segmenter.set_seeds(seed_map);
  }
}

TEST(Scalar_annotator, annotating_again_changes_nothing)
{
  const RS::Flat_mesh mesh = RS::read_flat_mesh(to_surface_mesh(cube()), RS::Mesh_data::POINTS);
  const RS::Partition regions = RS::Partition::from_labels(std::vector<int>{0, 0, 1, 1, 1, 1});
  const RS::Scalar_annotator<RS::Geometry_annotator<>> annotator(std::vector<double>{1, 2, 3, 4, 5, 6});
  auto graph = RS::build_region_adjacency_graph(mesh, regions, annotator);
  for (int round = 0; round < 2; ++round) {
    EXPECT_DOUBLE_EQ(graph[0].mean_scalar(), 1.5);
    EXPECT_DOUBLE_EQ(graph[1].mean_scalar(), 4.5);
    EXPECT_DOUBLE_EQ(graph[0].scalar, 3);
    annotator(graph, mesh, regions);
  }
}

TEST(Scalar_annotator, names_values_that_are_missing_or_not_finite)
{
  const Surface_mesh mesh = to_surface_mesh(cube());
  const auto message = [&](const std::vector<double>& values) -> std::string {
    try {
      RS::Segmenter(mesh, RS::parameters::method(method_of_scalar_alone(values, 1)));
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
