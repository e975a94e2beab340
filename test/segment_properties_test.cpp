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
#include <CGAL/Region_segmentation/Superfacets/internal/Patch_builder.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/extract_feature_lines.h>
#include <CGAL/Region_segmentation/segment.h>

#include <boost/property_map/function_property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
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

TEST_P(Two_step_properties_test, features_are_borders_of_regions)
{
  for_each_mesh(15, [](const Soup& soup, const Options& options, std::mt19937&) {
    const Result result = run(soup, options);
    for (const auto& [edge, faces] : faces_of_edges(soup)) {
      if (faces.size() == 1) {
        EXPECT_TRUE(result.features.at(edge));
      } else if (result.features.at(edge)) {
        EXPECT_NE(result.regions[faces[0]], result.regions[faces[1]]);
      }
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

TEST_P(Two_step_properties_test, foreign_maps_give_the_same_labels)
{
  for_each_mesh(6, [](const Soup& soup, const Options& options, std::mt19937& random) {
    Surface_mesh mesh = to_surface_mesh(soup);
    const Result expected = test::run(mesh, options);
    using Vertex = Surface_mesh::Vertex_index;
    using Face = Surface_mesh::Face_index;

    std::map<Vertex, Kernel::Point_3> stored;
    for (auto v : vertices(mesh))
      stored[v] = mesh.point(v);
    const auto by_value = boost::make_function_property_map<Vertex>(
      [&stored](Vertex v) { return stored.at(v); });
    // The points of the mesh itself must not matter then.
    for (auto v : vertices(mesh))
      mesh.point(v) = Kernel::Point_3(0, 0, 0);
    const auto same = [&](const Result& result) {
      EXPECT_EQ(result.regions, expected.regions);
      EXPECT_EQ(result.segments, expected.segments);
      EXPECT_EQ(result.features, expected.features);
    };
    same(test::run(mesh, options, [&](const auto& np) {
      return np.vertex_point_map(boost::make_assoc_property_map(stored));
    }));
    same(test::run(mesh, options, [&](const auto& np) { return np.vertex_point_map(by_value); }));

    std::map<Face, std::size_t> face_index;
    std::map<Vertex, std::size_t> vertex_index;
    std::vector<std::size_t> numbers(mesh.number_of_vertices() + mesh.number_of_faces());
    const auto shuffle = [&](std::size_t n) {
      numbers.resize(n);
      for (std::size_t i = 0; i < n; ++i)
        numbers[i] = i;
      std::shuffle(numbers.begin(), numbers.end(), random);
    };
    shuffle(mesh.number_of_faces());
    for (auto f : faces(mesh))
      face_index[f] = numbers[face_index.size()];
    shuffle(mesh.number_of_vertices());
    for (auto v : vertices(mesh))
      vertex_index[v] = numbers[vertex_index.size()];
    const auto all_foreign = [&](const auto& np) {
      return np.vertex_point_map(by_value)
        .face_index_map(boost::make_assoc_property_map(face_index))
        .vertex_index_map(boost::make_assoc_property_map(vertex_index));
    };
    same(test::run(mesh, options, all_foreign));
    const auto by_default = RP::number_of_segments(options.k);
    const Result learned = test::run(mesh, all_foreign(by_default)),
                 of_soup = test::run(to_surface_mesh(soup), by_default);
    EXPECT_EQ(learned.regions, of_soup.regions);
    EXPECT_EQ(learned.segments, of_soup.segments);
    same(test::run(mesh, options, [&](const auto& np) {
      return np.vertex_point_map(by_value).face_index_map(
        boost::make_function_property_map<Face>([&](Face f) { return face_index.at(f); }));
    }));
  });
}

// The same under changes of the mesh

void expect_same(const Result& a, const Result& b)
{
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(a.segments, b.segments);
  EXPECT_EQ(a.features, b.features);
}

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
    // Faces as pairs of polygon and old label, in a new order.
    std::vector<std::size_t> order(soup.polygons.size());
    for (std::size_t f = 0; f < order.size(); ++f)
      order[f] = f;
    std::shuffle(order.begin(), order.end(), random);
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

TEST_P(Properties_test, the_first_corner_of_a_face_changes_no_bit)
{
  for_each_mesh(8, [](const Soup& soup, const Options& options, std::mt19937& random) {
    Soup rotated = soup;
    for (Polygon& p : rotated.polygons)
      std::rotate(p.begin(), p.begin() + std::ptrdiff_t(random() % p.size()), p.end());
    expect_same(run(rotated, options), run(soup, options));
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
  std::string result = methods[int(std::get<0>(info.param))] + name(std::get<1>(info.param));
  std::replace(result.begin(), result.end(), ' ', '_');
  return result;
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
      try {
        outputs.run(Options(2).named());
        ADD_FAILURE() << "taken";
      } catch (const RS::Invalid_input& e) {
        EXPECT_NE(std::string(e.what()).find("vertex 7 "), std::string::npos) << e.what();
      }
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

/// Cancels at every call in turn.
template <typename Parameters>
void expect_that_cancelling_writes_nothing(const Surface_mesh& mesh, const Parameters& np)
{
  Visitor whole;
  Outputs(mesh).run(np.visitor(std::ref(whole)));
  ASSERT_GT(whole.calls.size(), 4u);
  for (std::size_t i = 1; i <= whole.calls.size(); ++i) {
    Visitor visitor;
    visitor.cancel_at = i;
    Outputs outputs(mesh);
    EXPECT_THROW(outputs.run(np.visitor(std::ref(visitor))), RS::Segmentation_cancelled);
    EXPECT_EQ(visitor.calls.size(), i);
    outputs.expect_untouched();
  }
}

TEST(Visitor_test, sees_the_stages_in_order_with_progress)
{
  const Surface_mesh mesh = to_surface_mesh(dumbbell());
  Visitor visitor;
  Outputs(mesh).run(Options(2, reference::Convexity::all).named().visitor(std::ref(visitor)));
  EXPECT_EQ(stages_of(visitor), stages_of_two_step);
  EXPECT_GT(visitor.calls.size(), 10u) << "merging tells about its steps";

  Visitor of_default;
  Outputs(mesh).run(RP::number_of_segments(2).visitor(std::ref(of_default)));
  EXPECT_EQ(stages_of(of_default), stages_of_default);
}

TEST(Visitor_test, sees_the_stages_where_nothing_is_merged)
{
  // As many segments as first regions, and more.
  const Surface_mesh mesh = to_surface_mesh(cube());
  for (std::size_t number : {6, 100}) {
    const Options options(number, reference::Convexity::all);
    Visitor visitor;
    Outputs(mesh).run(options.named().visitor(std::ref(visitor)));
    EXPECT_EQ(stages_of(visitor), stages_of_two_step) << number;
    expect_that_cancelling_writes_nothing(mesh, options.named());
  }
}

TEST(Visitor_test, sees_the_stages_of_stage_functions)
{
  const Surface_mesh mesh = to_surface_mesh(dumbbell());
  Outputs outputs(mesh);
  using Stages = std::vector<std::string>;
  Visitor detecting, growing, building;
  test::detect_feature_edges(mesh, outputs.features, Feature_options(),
                             RP::visitor(std::ref(detecting)));
  EXPECT_EQ(stages_of(detecting), (Stages{"reading", "features"}));
  test::grow_regions(mesh, outputs.features, outputs.regions, RP::visitor(std::ref(growing)));
  EXPECT_EQ(stages_of(growing), (Stages{"reading", "regions"}));
  test::build_region_adjacency_graph(mesh, outputs.regions, RP::visitor(std::ref(building)));
  EXPECT_EQ(stages_of(building), (Stages{"reading", "graph"}));
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

TEST(Visitor_test, can_cancel_anywhere_and_nothing_is_written)
{
  const Surface_mesh mesh = to_surface_mesh(dumbbell());
  expect_that_cancelling_writes_nothing(mesh, Options(2, reference::Convexity::all).named());
  expect_that_cancelling_writes_nothing(mesh, RP::number_of_segments(2));
}

TEST(Visitor_test, can_cancel_while_patches_are_made_and_nothing_is_written)
{
  // Beside a large square each face of a small grid is small enough to be joined.
  const Surface_mesh mesh = to_surface_mesh(
    joined(triangulated(grid(8, 8)), translated(scaled(grid(1, 1), 1000), 2000, 0, 0)));
  const auto patches = RS::internal::Patch_builder::build(RS::make_surface(mesh), 0,
                                                          RS::Execution());
  ASSERT_LT(patches.fine.size(), num_faces(mesh) / 4);
  expect_that_cancelling_writes_nothing(mesh, RP::number_of_segments(2));
  expect_that_cancelling_writes_nothing(mesh, Options(2, reference::Convexity::all).named());
}

TEST(Visitor_test, can_cancel_stage_functions_and_nothing_is_written)
{
  const Surface_mesh mesh = to_surface_mesh(dumbbell());
  for (std::size_t i = 1; i <= 2; ++i) {
    Visitor visitor;
    visitor.cancel_at = i;
    Outputs outputs(mesh);
    EXPECT_THROW(test::detect_feature_edges(mesh, outputs.features, Feature_options(),
                                            RP::visitor(std::ref(visitor))),
                 RS::Segmentation_cancelled);
    visitor.calls.clear();
    EXPECT_THROW(
      test::grow_regions(mesh, outputs.features, outputs.regions, RP::visitor(std::ref(visitor))),
      RS::Segmentation_cancelled);
    visitor.calls.clear();
    EXPECT_THROW(
      test::build_region_adjacency_graph(mesh, outputs.regions, RP::visitor(std::ref(visitor))),
      RS::Segmentation_cancelled);
    outputs.expect_untouched();
  }
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
