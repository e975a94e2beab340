// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever the coordinates and the labels: nothing is read or written out of bounds, every result
// is a segmentation, and errors leave what is promised. Also compiled with sanitizers.

#include "meshes.h"
#include "oracles.h"
#include "segments.h"
#include "user_method.h"

#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Segments/compute_segment_topology.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/segment.h>
#ifdef TEST_EIGEN
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#endif

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <functional>
#include <iterator>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace robustness_test {

namespace RS = CGAL::Region_segmentation;
namespace RP = CGAL::Region_segmentation::parameters;
using namespace test;

/// Any finite number, each bit pattern with the same probability; often one of a few that are hard.
double any_finite(std::mt19937& random)
{
  constexpr double hard[] = {0.,      -0.,    1e-160, 1e154,     -1e308,
                             1.7e308, 5e-324, 1.,     1 + 1e-15, -2.2e-308};
  if (random() % 2)
    return hard[random() % std::size(hard)];
  while (true) {
    const std::uint64_t bits = (std::uint64_t(random()) << 32) | random();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value))
      return value;
  }
}

/// A mesh of a family, some of whose coordinates, or all, are any numbers.
Soup wild_mesh(Family family, unsigned seed)
{
  std::mt19937 random(seed);
  Soup soup = random_mesh(family, seed);
  const unsigned one_of = std::array<unsigned, 3>{1, 10, 100}[random() % 3];
  for (Point& p : soup.points)
    for (double& x : p)
      if (random() % one_of == 0)
        x = any_finite(random);
  return soup;
}

struct Robustness_test : ::testing::TestWithParam<Family>
{
  template <typename F>
  void for_each_wild_mesh(unsigned seeds, const F& f) const
  {
    for (unsigned seed = 0; seed < seeds; ++seed) {
      SCOPED_TRACE(name(GetParam()) + ", seed " + std::to_string(seed));
      f(wild_mesh(GetParam(), seed), seed);
    }
  }
};

TEST_P(Robustness_test, any_finite_coordinates_give_segments)
{
  for_each_wild_mesh(6, [](const Soup& soup, unsigned seed) {
    const Surface_mesh mesh = to_surface_mesh(soup);
    const std::size_t k = 1 + seed;
    const Options options(k, reference::Convexity::all, 20);
    const auto expect_segments = [&](const auto& np) {
      const Result result = run(mesh, np);
      EXPECT_TRUE(is_numbered_by_first_face(result.segments, result.number_of_segments));
      EXPECT_TRUE(is_connected(soup, result.segments));
      EXPECT_TRUE(nests(result.regions, result.segments));
    };
    expect_segments(RP::number_of_segments(k).component_links(false));
    expect_segments(RP::number_of_segments(k).method(options.method()).component_links(false));
#ifdef TEST_EIGEN
    expect_segments(RP::method(RS::Smooth_faces()).component_links(false));
#endif
    segments_of(mesh, RP::number_of_segments(k)); // with links
    segments_of(mesh, RP::number_of_segments(k).method(options.method()));
#ifdef TEST_EIGEN
    segments_of(mesh, RP::method(RS::Smooth_faces()));
#endif
  });
}

TEST_P(Robustness_test, a_segmenter_takes_constraints_and_seeds_of_wild_meshes)
{
  for_each_wild_mesh(3, [](const Soup& soup, unsigned seed) {
    std::mt19937 random(seed);
    const Surface_mesh mesh = to_surface_mesh(soup);
    RS::Segmenter segmenter(mesh, RP::component_links(false));
    const std::set<Edge> constrained = random_edges(soup, 10, random);
    segmenter.add_constraints(edge_map(mesh, constrained));
    auto seeds = face_map(mesh, std::size_t(-1));
    for (std::size_t i = 0; i < 5; ++i)
      put(seeds, Surface_mesh::Face_index(Surface_mesh::size_type(random() % num_faces(mesh))), i);
    segmenter.set_seeds(seeds);
    const auto segments = face_map(mesh);
    const std::size_t n = segmenter.segment(segments, 3);
    EXPECT_TRUE(is_numbered_by_first_face(labels_of(mesh, segments), n));
    EXPECT_TRUE(is_connected(soup, labels_of(mesh, segments), constrained));
    for (auto f : faces(mesh))
      for (auto g : faces(mesh))
        if (get(seeds, f) < get(seeds, g) && get(seeds, g) != std::size_t(-1)) {
          ASSERT_NE(get(segments, f), get(segments, g)) << "of different seeds";
        }
  });
}

TEST_P(Robustness_test, what_comes_after_takes_any_labels_and_coordinates)
{
  for_each_wild_mesh(3, [](const Soup& soup, unsigned seed) {
    const Surface_mesh mesh = to_surface_mesh(soup);
    const auto labels = face_labels(mesh, random_labels(soup, 4, seed));
    std::vector<RS::Segment_topology<std::size_t>> topology;
    RS::compute_segment_topology(mesh, labels, std::back_inserter(topology));
    std::vector<RS::Segment_border<Surface_mesh, std::size_t>> borders;
    RS::extract_segment_borders(mesh, labels, std::back_inserter(borders));
    const auto is_border = edge_map(mesh);
    RS::mark_segment_borders(mesh, labels, is_border);
    std::vector<RS::Segment_piece<Surface_mesh, Surface_mesh, std::size_t>> pieces;
    RS::split_into_segments(mesh, labels, std::back_inserter(pieces),
                            RS::parameters::edge_is_constrained_map(is_border));
    EXPECT_EQ(pieces.size(), topology.size());
  });
}

INSTANTIATE_TEST_SUITE_P(families, Robustness_test, ::testing::ValuesIn(all_families),
                         [](const ::testing::TestParamInfo<Family>& info) {
                           std::string result = name(info.param);
                           std::replace(result.begin(), result.end(), ' ', '_');
                           return result;
                         });

// A map whose put() throws

struct Full : std::exception
{};

/// Takes a number of values, then throws.
struct Map_of_few
{
  using key_type = Surface_mesh::Face_index;
  using value_type = std::size_t;
  using reference = void;
  using category = boost::writable_property_map_tag;

  std::vector<std::size_t>* values;
  std::size_t* places;

  friend void put(const Map_of_few& map, key_type f, std::size_t value)
  {
    if (*map.places == 0)
      throw Full();
    --*map.places;
    (*map.values)[f] = value;
  }
};

TEST(Throwing_map_test, keeps_what_was_written_and_the_other_maps_are_untouched)
{
  const Surface_mesh mesh = to_surface_mesh(dumbbell());
  const std::size_t size = num_faces(mesh), written = 7;
  const auto np = RP::number_of_segments(3);
  const Labels expected = segments_of(mesh, np);
  Labels values(size, 99);
  std::size_t places = written;
  const auto regions = face_map(mesh, 78);
  RS::Merge_tree tree(2);
  EXPECT_THROW(RS::segment(mesh, Map_of_few{&values, &places},
                           np.region_map(regions).merge_tree(std::ref(tree))),
               Full);
  for (std::size_t f = 0; f < size; ++f)
    EXPECT_EQ(values[f], f < written ? expected[f] : 99) << "faces are written in their order";
  EXPECT_EQ(labels_of(mesh, regions), Labels(size, 78));
  EXPECT_EQ(tree.number_of_regions(), 2u);
}

TEST(Throwing_map_test, leaves_a_segmenter_as_it_was)
{
  const Surface_mesh mesh = to_surface_mesh(dumbbell());
  const RS::Segmenter segmenter(mesh);
  Labels values(num_faces(mesh), 99);
  std::size_t places = 3;
  EXPECT_THROW(segmenter.segment(Map_of_few{&values, &places}, 3), Full);
  places = num_faces(mesh);
  segmenter.segment(Map_of_few{&values, &places}, 3);
  EXPECT_EQ(values, segments_of(mesh, RP::number_of_segments(3)));
}

// A policy is not even initialized where nothing is to be merged: for step two of the paper that
// takes quadratic time.

struct Unused_policy
{
  template <typename Graph>
  void initialize(const Graph&)
  {
    ADD_FAILURE() << "initialized";
  }
  template <typename Graph>
  std::optional<RS::Merge_candidate> next(const Graph&)
  {
    return std::nullopt;
  }
  template <typename Graph>
  void on_merge(const Graph&, const typename Graph::Merge&)
  {}
};

TEST(Unused_policy_test, as_many_segments_as_regions)
{
  const RS::Surface surface = RS::make_surface(to_surface_mesh(cube()));
  const RS::Requested_regions requested = RS::requested_regions(surface, Single_faces()(surface),
                                                                RS::Seeds());
  for (const std::size_t k : {6, 100}) {
    auto graph = RS::build_region_adjacency_graph(surface, requested.regions);
    const RS::Merge_tree tree = RS::merge_requested_regions(surface, requested, graph,
                                                            Unused_policy(), k, RS::Execution());
    EXPECT_TRUE(tree.merges().empty());
  }
}

// Depth: nothing recurs as deep as the mesh is large.

TEST(Depth_test, a_strip_of_two_hundred_thousand_faces)
{
  Surface_mesh mesh;
  constexpr unsigned faces = 200000;
  using Vertex = Surface_mesh::Vertex_index;
  for (unsigned i = 0; i < faces + 2; ++i)
    mesh.add_vertex(Kernel::Point_3(double(i) * i, i % 2, 0));
  for (unsigned i = 0; i < faces; ++i)
    mesh.add_face(Vertex(i + i % 2), Vertex(i + 1 - i % 2), Vertex(i + 2));
  EXPECT_EQ(RS::segment(mesh, face_map(mesh), RP::number_of_segments(3)), 3u);
}

} // namespace robustness_test
