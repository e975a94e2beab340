// SPDX-License-Identifier: GPL-3.0-or-later

// What the package promises of every segmentation, over random meshes.

#include "meshes.h"
#include "oracles.h"
#include "stages.h"
#include "user_method.h"

#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
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
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace segment_properties_test {

namespace RS = CGAL::Region_segmentation;
namespace RP = CGAL::Region_segmentation::parameters;
using namespace test;

enum class Method { TWO_STEP, VISIBILITY, LEARNED };

/// A run by any method; features are those of two-step alone.
Result run_by(Method method, const Soup& soup, const Options& options)
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  const auto run_with = [&](const auto& any_method) {
    const auto np = RP::number_of_segments(options.k).method(any_method).component_links(false);
    return options.constrained_edges.empty()
             ? run(mesh, np)
             : run(mesh, np.edge_is_constrained_map(edge_map(mesh, options.constrained_edges)));
  };
  return method == Method::TWO_STEP     ? run(mesh, options)
         : method == Method::VISIBILITY ? run_with(RS::Visibility_merging())
                                        : run_with(RS::Learned_merging());
}

struct Properties_test : ::testing::TestWithParam<std::tuple<Method, Family>>
{
  static Method method() { return std::get<0>(GetParam()); }
  static Family family() { return std::get<1>(GetParam()); }

  static Result run(const Soup& soup, const Options& options)
  {
    return run_by(method(), soup, options);
  }

  /// Calls `f(soup, options, random)` for meshes of the family, with their seeds in the trace.
  template <typename F>
  void for_each_mesh(unsigned seeds, F f) const
  {
    for (unsigned seed = 0; seed < seeds; ++seed) {
      SCOPED_TRACE(name(family()) + ", seed " + std::to_string(seed));
      std::mt19937 random(seed + 5000);
      const Soup soup = random_mesh(family(), seed + 5000);
      f(soup, random_options(random), random);
      if (HasFatalFailure())
        return;
    }
  }
};

/// What only two-step has: feature edges, and foreign maps of every kind.
struct Two_step_properties_test : Properties_test
{};
struct Closed_surfaces_test : Properties_test
{};

TEST_P(Properties_test, labels_are_dense_ordered_and_connected)
{
  for_each_mesh(12, [](const Soup& soup, Options options, std::mt19937& random) {
    if (random() % 2)
      options.constrained_edges = random_edges(soup, 10, random);
    const Result result = run(soup, options);
    const std::size_t n = result.number_of_segments;
    EXPECT_TRUE(is_numbered_by_first_face(result.segments, n));
    EXPECT_TRUE(is_numbered_by_first_face(result.regions, result.tree.number_of_regions()));
    EXPECT_TRUE(is_connected(soup, result.regions, options.constrained_edges));
    EXPECT_TRUE(is_connected(soup, result.segments, options.constrained_edges));
    EXPECT_TRUE(nests(result.regions, result.segments));
    EXPECT_TRUE(separates(soup, options.constrained_edges, result.regions, result.segments));
    EXPECT_LE(n, result.tree.number_of_regions());
    EXPECT_GE(n, number_of_components(soup));
    if (options.constrained_edges.empty()) {
      const std::size_t reachable = (std::max)(options.k, number_of_components(soup));
      EXPECT_EQ(n, (std::min)(reachable, result.tree.number_of_regions()));
    } else if (n != options.k) {
      EXPECT_EQ(result.tree.merges().size(), result.tree.number_of_regions() - n);
    }
  });
}

TEST_P(Properties_test, segmentations_of_one_tree_nest)
{
  for_each_mesh(10, [](const Soup& soup, Options options, std::mt19937&) {
    options.k = 1;
    const Result result = run(soup, options);
    Labels finer = result.regions;
    for (std::size_t k = result.tree.number_of_regions(); k >= result.number_of_segments && k > 0;
         --k) {
      const auto partition = result.tree.partition_at_count(k);
      ASSERT_EQ(partition.number_of_parts(), k);
      const Labels labels = labels_of(result.regions, partition);
      ASSERT_TRUE(is_numbered_by_first_face(labels, k));
      ASSERT_TRUE(is_connected(soup, labels));
      ASSERT_TRUE(nests(finer, labels));
      finer = labels;
    }
    EXPECT_EQ(finer, result.segments);
  });
}

struct Length_cost
{
  template <typename Graph>
  double operator()(const Graph& g, typename Graph::section_descriptor s) const
  {
    return -g[s].length;
  }
};

TEST_P(Two_step_properties_test, a_policy_that_does_not_know_k_gives_one_tree)
{
  for_each_mesh(5, [](const Soup& soup, Options options, std::mt19937&) {
    const Surface_mesh mesh = to_surface_mesh(soup);
    const auto method = make_user_method(
      [two_step = options.method()](const RS::Surface& s) { return two_step.prepare(s).regions; },
      RS::Lowest_cost_first<Length_cost>());
    const auto with = [&](std::size_t k) {
      return test::run(mesh, RP::number_of_segments(k).method(method));
    };
    const Result whole = with(1);
    for (std::size_t k : {2, 3, 7, 20}) {
      const Result direct = with(k);
      ASSERT_EQ(labels_of(whole.regions, whole.tree.partition_at_count(k)), direct.segments);
      // The tree is complete for every k.
      ASSERT_EQ(direct.tree.merges().size(), whole.tree.merges().size());
      for (std::size_t i = 0; i < whole.tree.merges().size(); ++i)
        ASSERT_EQ(direct.tree.merges()[i].removed, whole.tree.merges()[i].removed);
    }
  });
}

// The same from foreign property maps

std::vector<std::size_t> random_order(std::size_t size, std::mt19937& random)
{
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

TEST_P(Two_step_properties_test, foreign_maps_give_the_same_labels)
{
  for_each_mesh(6, [](const Soup& soup, const Options& options, std::mt19937& random) {
    Surface_mesh mesh = to_surface_mesh(soup);
    const auto by_default = RP::number_of_segments(options.k);
    const Result expected = test::run(mesh, options), learned = test::run(mesh, by_default);
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
      test::run(mesh, options, [&](const auto& np) { return np.vertex_point_map(by_reference); }),
      expected);
    expect_same(
      test::run(mesh, options, [&](const auto& np) { return np.vertex_point_map(by_value); }),
      expected);
    expect_same(test::run(mesh, options, all_foreign), expected);
    expect_same(test::run(mesh, all_foreign(by_default)), learned);
  });
}

// The same under changes of the mesh

TEST_P(Properties_test, scaling_by_a_power_of_two_changes_no_bit)
{
  for_each_mesh(5, [](const Soup& soup, const Options& options, std::mt19937&) {
    const Result expected = run(soup, options);
    for (int exponent : {-1000, -600, -1, 10, 600, 1010}) {
      const Result result = run(scaled(soup, std::ldexp(1, exponent)), options);
      expect_same(result, expected);
      ASSERT_EQ(result.tree.merges().size(), expected.tree.merges().size());
      for (std::size_t i = 0; i < expected.tree.merges().size(); ++i)
        EXPECT_EQ(result.tree.merges()[i].removed, expected.tree.merges()[i].removed);
    }
  });
}

TEST_P(Properties_test, an_exact_offset_of_a_million_diameters_changes_no_bit)
{
  // Coordinates are multiples of 2^-16 below 2^7; the offsets keep them within 53 bits.
  for_each_mesh(8, [](const Soup& soup, const Options& options, std::mt19937&) {
    expect_same(run(translated(soup, 1 << 27, -(1 << 26), 3 * (1 << 25)), options),
                run(soup, options));
  });
}

// A flat cap is degenerate by its exact coordinates; moved, it may be so no more.
bool is_stable(Family family)
{
  return !has_degenerate_faces(family);
}

TEST_P(Properties_test, motion_and_scaling_change_no_label)
{
  if (!is_stable(family()))
    GTEST_SKIP() << "flat caps do not survive rounding";
  for_each_mesh(8, [](const Soup& soup, const Options& options, std::mt19937& random) {
    const Result expected = run(soup, options);
    const double a = double(random() % 1000), b = double(random() % 1000);
    const auto rotated = mapped(soup, [=](const Point& p) {
      const double x = std::cos(a) * p[0] - std::sin(a) * p[1],
                   y = std::sin(a) * p[0] + std::cos(a) * p[1];
      return Point{x, std::cos(b) * y - std::sin(b) * p[2], std::sin(b) * y + std::cos(b) * p[2]};
    });
    const Soup& base = soup;
    for (const Soup& moved :
         {rotated, translated(rotated, 0.1, 1000.3, -7), translated(base, 1.1e7, -2.3e7, 0.7e7),
          scaled(rotated, 1e-30), scaled(base, 1e30), scaled(base, 3), scaled(base, 1e-90),
          scaled(base, 1e90)})
      expect_same(run(moved, options), expected);
  });
}

// Where costs of other methods are equal, as on a regular torus, they go by number.
TEST_P(Two_step_properties_test, renumbering_renames)
{
  if (!is_stable(family()))
    GTEST_SKIP() << "degenerate faces have ties, which go by number";
  for_each_mesh(8, [](const Soup& soup, const Options& options, std::mt19937& random) {
    const Result expected = run(soup, options);
    Soup other = soup;
    std::vector<std::size_t> new_of_old;
    shuffle_vertices(other, random, new_of_old);
    const Soup unshuffled = other;
    const std::vector<std::size_t> order = random_order(soup.polygons.size(), random);
    Labels segments, regions;
    for (std::size_t f = 0; f < order.size(); ++f) {
      Polygon p = unshuffled.polygons[order[f]];
      std::rotate(p.begin(), p.begin() + std::ptrdiff_t(random() % p.size()), p.end());
      other.polygons[f] = p;
      segments.push_back(expected.segments[order[f]]);
      regions.push_back(expected.regions[order[f]]);
    }
    const Result result = run(other, options);
    EXPECT_EQ(result.regions, renumbered(regions));
    EXPECT_EQ(result.segments, renumbered(segments));
    for (const auto& [edge, is_feature] : expected.features) // none, but of two-step
      EXPECT_EQ(result.features.at(make_edge(new_of_old[edge.first], new_of_old[edge.second])),
                is_feature);
  });
}

TEST_P(Closed_surfaces_test, inside_out_have_the_same_labels)
{
  for_each_mesh(4, [](const Soup& soup, const Options& options, std::mt19937&) {
    expect_same(run(reversed(soup), options), run(soup, options));
  });
}

TEST_P(Closed_surfaces_test, are_turned_component_by_component)
{
  for_each_mesh(2, [](const Soup& soup, const Options& options, std::mt19937&) {
    const Soup large = translated(scaled(soup, 4), 100, 0, 0);
    const Result expected = run(joined(large, soup), options);
    expect_same(run(joined(reversed(large), soup), options), expected);
    expect_same(run(joined(reversed(large), reversed(soup)), options), expected);
    expect_same(run(joined(large, reversed(soup)), options), expected);
  });
}

std::string parameter_name(const ::testing::TestParamInfo<std::tuple<Method, Family>>& info)
{
  const char* const methods[] = {"two_step_", "visibility_", "learned_"};
  return methods[int(std::get<0>(info.param))] + family_in_name(std::get<1>(info.param));
}
INSTANTIATE_TEST_SUITE_P(families, Properties_test,
                         ::testing::Combine(::testing::Values(Method::TWO_STEP, Method::VISIBILITY,
                                                              Method::LEARNED),
                                            ::testing::ValuesIn(all_families)),
                         parameter_name);
INSTANTIATE_TEST_SUITE_P(
  families, Closed_surfaces_test,
  ::testing::Combine(::testing::Values(Method::TWO_STEP, Method::VISIBILITY, Method::LEARNED),
                     ::testing::Values(Family::SPHERE, Family::TORUS, Family::BLOCKS)),
  parameter_name);
INSTANTIATE_TEST_SUITE_P(families, Two_step_properties_test,
                         ::testing::Combine(::testing::Values(Method::TWO_STEP),
                                            ::testing::ValuesIn(all_families)),
                         parameter_name);

// Bad input, and outputs that stay as they were

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

TEST(Bad_input_test, a_point_that_is_not_finite_is_named)
{
  for (double bad : {std::nan(""), std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity()})
    for (int coordinate = 0; coordinate < 3; ++coordinate) {
      Soup soup = dumbbell();
      soup.points[7][coordinate] = bad;
      const Surface_mesh mesh = to_surface_mesh(soup);
      Outputs outputs(mesh);
      EXPECT_TRUE(contains(message_of([&] { outputs.run(Options(2).named()); }), "vertex 7 "));
      outputs.expect_untouched();
      EXPECT_THROW(test::detect_feature_edges(mesh, outputs.features), RS::Invalid_input);
      EXPECT_THROW(test::extract_feature_lines(mesh, outputs.features, CGAL::Emptyset_iterator()),
                   RS::Invalid_input);
      EXPECT_THROW(test::grow_regions(mesh, outputs.features, outputs.regions), RS::Invalid_input);
      EXPECT_THROW(test::build_region_adjacency_graph(mesh, face_map(mesh, 0)), RS::Invalid_input);
      outputs.expect_untouched();
    }
}

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
