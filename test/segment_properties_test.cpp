// SPDX-License-Identifier: GPL-3.0-or-later

// Segmentations do not depend on the kind of maps, the place and the size of a mesh; what visitors
// are told. (properties_test.cpp: any soup; reference_test.cpp: what the labels are.)

#include "meshes.h"
#include "oracles.h"
#include "stages.h"

#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/extract_feature_lines.h>
#include <CGAL/Region_segmentation/segment.h>

#include <boost/property_map/function_property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace segment_properties_test {

namespace RS = CGAL::Region_segmentation;
namespace RP = CGAL::Region_segmentation::parameters;
using namespace test;

// The same from foreign property maps

std::vector<std::size_t> random_order(std::size_t size, std::mt19937& random)
{
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

TEST(Foreign_maps_test, give_the_same_labels)
{
  for_each_random_mesh(all_families, 6, [](const Soup& soup, unsigned seed) {
    std::mt19937 random(seed);
    const Options options = random_options(random);
    Surface_mesh mesh = to_surface_mesh(soup);
    const auto by_default = RP::number_of_segments(options.k);
    const Result expected = run(mesh, options), learned = run(mesh, by_default);
    using Vertex = Surface_mesh::Vertex_index;
    using Face = Surface_mesh::Face_index;

    std::map<Vertex, Kernel::Point_3> stored;
    for (auto v : vertices(mesh)) {
      stored[v] = mesh.point(v);
      mesh.point(v) = Kernel::Point_3(0, 0, 0); // which must not matter
    }
    const auto by_reference = boost::make_assoc_property_map(stored);
    const auto by_value = boost::make_function_property_map<Vertex>(
      [&stored](Vertex v) { return stored.at(v); });
    const auto face_numbers = random_order(mesh.number_of_faces(), random),
               vertex_numbers = random_order(mesh.number_of_vertices(), random);
    const auto number_of_face = boost::make_function_property_map<Face>(
      [&](Face f) { return face_numbers[f]; });
    const auto number_of_vertex = boost::make_iterator_property_map(vertex_numbers.begin(),
                                                                    get(boost::vertex_index, mesh));
    const auto all_foreign = [&](const auto& np) {
      return np.vertex_point_map(by_value)
        .face_index_map(number_of_face)
        .vertex_index_map(number_of_vertex);
    };
    expect_same(
      run(mesh, options, [&](const auto& np) { return np.vertex_point_map(by_reference); }),
      expected);
    expect_same(run(mesh, options, [&](const auto& np) { return np.vertex_point_map(by_value); }),
                expected);
    expect_same(run(mesh, options, all_foreign), expected);
    expect_same(run(mesh, all_foreign(by_default)), learned);
  });
}

// The same after motions

/// Expects that soups have the labels of another one, by each method that has a tree.
void expect_same_labels(const std::vector<Soup>& moved, const Soup& soup, const Options& options)
{
  const auto expect_by = [&](const auto& method) {
    const auto np = RP::number_of_segments(options.k).method(method).component_links(false);
    const Result expected = run(to_surface_mesh(soup), np);
    for (const Soup& other : moved)
      expect_same(run(to_surface_mesh(other), np), expected);
  };
  expect_by(options.method());
  expect_by(RS::Visibility_merging());
  expect_by(RS::Learned_merging());
}

TEST(Motion_test, an_exact_offset_of_a_million_diameters_changes_no_label)
{
  // Coordinates are multiples of 2^-16 below 2^7; the offsets keep them within 53 bits.
  for_each_random_mesh(all_families, 8, [](const Soup& soup, unsigned seed) {
    std::mt19937 random(seed);
    expect_same_labels({translated(soup, 1 << 27, -(1 << 26), 3 * (1 << 25))}, soup,
                       random_options(random));
  });
}

TEST(Motion_test, rotation_and_scaling_change_no_label)
{
  for_each_random_mesh(all_families, 8, [](const Soup& base, unsigned seed) {
    if (number_of_proper_faces(base) < base.polygons.size())
      return; // a flat cap is degenerate by its exact coordinates; moved, it may be so no more
    std::mt19937 random(seed);
    const Options options = random_options(random);
    const double about_z = double(random() % 1000), about_x = double(random() % 1000);
    const Soup turned = rotated(base, about_z, about_x);
    expect_same_labels({turned, translated(turned, 0.1, 1000.3, -7),
                        translated(base, 1.1e7, -2.3e7, 0.7e7), scaled(turned, 1e-30),
                        scaled(base, 1e30), scaled(base, 3), scaled(base, std::ldexp(1, -1000)),
                        scaled(base, std::ldexp(1, 1010))},
                       base, options);
  });
}

// Where costs of other methods are equal, as on a regular torus, they go by number.
TEST(Motion_test, renumbering_renames_the_segments_of_two_step)
{
  for_each_random_mesh(all_families, 8, [](const Soup& soup, unsigned seed) {
    if (number_of_proper_faces(soup) < soup.polygons.size())
      return; // degenerate faces have ties, which go by number
    std::mt19937 random(seed);
    const Options options = random_options(random);
    const Labels expected = run(soup, options).segments;
    Soup other = soup;
    std::vector<std::size_t> new_of_old;
    shuffle_vertices(other, random, new_of_old);
    const std::vector<Polygon> polygons = other.polygons;
    const std::vector<std::size_t> order = random_order(polygons.size(), random);
    Labels in_order;
    for (std::size_t f = 0; f < order.size(); ++f) {
      Polygon& p = other.polygons[f] = polygons[order[f]];
      std::rotate(p.begin(), p.begin() + std::ptrdiff_t(random() % p.size()), p.end());
      in_order.push_back(expected[order[f]]);
    }
    EXPECT_EQ(run(other, options).segments, renumbered(in_order));
  });
}

// Visitors, and outputs that stay as they were

struct Outputs
{
  explicit Outputs(const Surface_mesh& m)
    : mesh(m)
    , segments(face_map(m, 77))
    , regions(face_map(m, 78))
    , features(edge_map(m, std::uint8_t(1)))
  {
    tree.push_back({0, 1, 5});
  }

  template <typename Parameters>
  std::size_t run(const Parameters& np)
  {
    return RS::segment(mesh, segments, np.region_map(regions).merge_tree(std::ref(tree)));
  }

  void expect_untouched() const
  {
    EXPECT_EQ(labels_of(mesh, segments), Labels(num_faces(mesh), 77));
    EXPECT_EQ(labels_of(mesh, regions), Labels(num_faces(mesh), 78));
    EXPECT_EQ(count(flags_of(mesh, features)), num_edges(mesh));
    EXPECT_EQ(tree.merges().size(), 1u);
    EXPECT_EQ(tree.number_of_regions(), 2u);
  }

  using Face_map = decltype(face_map(std::declval<Surface_mesh>()));
  using Edge_map = decltype(edge_map(std::declval<Surface_mesh>()));
  const Surface_mesh& mesh;
  Face_map segments, regions;
  Edge_map features;
  RS::Merge_tree tree{2};
};

struct Visitor
{
  std::vector<std::pair<std::string, double>> calls;
  std::size_t cancel_at = 1000000;

  bool on_progress(const char* stage, double fraction)
  {
    calls.push_back({stage, fraction});
    return calls.size() < cancel_at;
  }
};

/// The stages in order; within each of them progress never falls.
std::vector<std::string> stages_of(const Visitor& visitor)
{
  std::vector<std::string> stages;
  double last = 0;
  for (const auto& [stage, fraction] : visitor.calls) {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    if (stages.empty() || stages.back() != stage) {
      stages.push_back(stage);
      last = 0;
    }
    EXPECT_GE(fraction, last) << stage;
    last = fraction;
  }
  return stages;
}

const std::vector<std::string> stages_of_two_step = {"reading", "regions", "graph", "merging"};
const std::vector<std::string> stages_of_default = {"reading", "regions", "rays", "draws",
                                                    "borders"};

/// `run(outputs, visitor)` tells a visitor these stages, and writes nothing if it is cancelled, at
/// whatever call.
template <typename Run>
void expect_stages(const std::vector<std::string>& stages, const Surface_mesh& mesh, const Run& run)
{
  Visitor whole;
  Outputs all(mesh);
  run(all, std::ref(whole));
  EXPECT_EQ(stages_of(whole), stages);
  for (std::size_t i = 1; i <= whole.calls.size(); ++i) {
    Visitor visitor;
    visitor.cancel_at = i;
    Outputs outputs(mesh);
    EXPECT_THROW(run(outputs, std::ref(visitor)), RS::Segmentation_cancelled);
    EXPECT_EQ(visitor.calls.size(), i);
    outputs.expect_untouched();
  }
}

TEST(Visitor_test, sees_the_stages_in_order_and_can_cancel_everywhere)
{
  const auto two_step = [](std::size_t k) {
    return [k](Outputs& outputs, auto visitor) {
      outputs.run(Options(k, reference::Convexity::all).named().visitor(visitor));
    };
  };
  const auto by_default = [](Outputs& outputs, auto visitor) {
    outputs.run(RP::number_of_segments(2).visitor(visitor));
  };
  const Surface_mesh mesh = to_surface_mesh(dumbbell()), box = to_surface_mesh(cube());
  expect_stages(stages_of_two_step, mesh, two_step(2));
  expect_stages(stages_of_default, mesh, by_default);
  for (std::size_t k : {6, 100}) // as many segments as first regions, and more: nothing is merged
    expect_stages(stages_of_two_step, box, two_step(k));
  // Beside a large square each face of a small grid is so small that patches are made.
  const Surface_mesh with_patches = to_surface_mesh(
    joined(triangulated(grid(8, 8)), translated(scaled(grid(1, 1), 1000), 2000, 0, 0)));
  expect_stages(stages_of_default, with_patches, by_default);
  expect_stages(stages_of_two_step, with_patches, two_step(2));

  expect_stages({"reading", "features"}, mesh, [](Outputs& outputs, auto visitor) {
    test::detect_feature_edges(outputs.mesh, outputs.features, Feature_options(),
                               RP::visitor(visitor));
  });
  expect_stages({"reading", "regions"}, mesh, [](Outputs& outputs, auto visitor) {
    test::grow_regions(outputs.mesh, outputs.features, outputs.regions, RP::visitor(visitor));
  });
  expect_stages({"reading", "graph"}, mesh, [](Outputs& outputs, auto visitor) {
    test::build_region_adjacency_graph(outputs.mesh, outputs.regions, RP::visitor(visitor));
  });
}

TEST(Visitor_test, sees_progress_inside_long_stages)
{
  const Surface_mesh mesh = to_surface_mesh(sphere(6)); // 32,768 faces
  Visitor visitor;
  RS::segment(mesh, face_map(mesh), RP::number_of_segments(8).visitor(std::ref(visitor)));
  EXPECT_EQ(stages_of(visitor), stages_of_default);
  std::map<std::string, std::size_t> calls;
  for (const auto& call : visitor.calls)
    ++calls[call.first];
  for (const std::string& stage : stages_of_default)
    EXPECT_GT(calls[stage], 1u) << stage;
}

TEST(Visitor_test, changes_nothing)
{
  const Surface_mesh mesh = to_surface_mesh(random_mesh(Family::BLOCKS, 1));
  const Options options(3, reference::Convexity::all, 20);
  Visitor visitor;
  expect_same(run(mesh, options, [&](const auto& np) { return np.visitor(std::ref(visitor)); }),
              run(mesh, options));
  EXPECT_FALSE(visitor.calls.empty());
}

} // namespace segment_properties_test
