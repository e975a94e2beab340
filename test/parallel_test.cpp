// SPDX-License-Identifier: GPL-3.0-or-later

// Parallel_tag gives the same bits as Sequential_tag.

#include "meshes.h"

#include <CGAL/region_segmentation.h>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RS = CGAL::Region_segmentation;
using namespace test;

struct Outputs
{
  std::size_t number_of_segments;
  std::vector<std::size_t> segments, regions;
  std::vector<bool> features;

  bool operator==(const Outputs& other) const
  {
    return number_of_segments == other.number_of_segments && segments == other.segments &&
           regions == other.regions && features == other.features;
  }
};

template <typename ConcurrencyTag, typename Policy>
Outputs run(const Surface_mesh& mesh, const Policy& policy, RS::Feature_convexity convexity)
{
  Outputs result;
  result.segments.resize(num_faces(mesh));
  result.regions.resize(num_faces(mesh));
  result.features.resize(num_edges(mesh));
  const auto by_face = [&mesh](std::vector<std::size_t>& values) {
    return boost::make_iterator_property_map(values.begin(), get(boost::face_index, mesh));
  };
  const auto features =
      boost::make_iterator_property_map(result.features.begin(), get(boost::edge_index, mesh));
  result.number_of_segments = RS::segment<ConcurrencyTag>(
      mesh, by_face(result.segments),
      RS::parameters::number_of_segments(7)
          .merging_policy(policy)
          .feature_convexity(convexity)
          .maximum_angle(3)
          .region_map(by_face(result.regions))
          .edge_is_feature_map(features));
  return result;
}

/// A sheet of several ranges of faces, some of them without area, numbered at random.
Soup large_sheet(unsigned seed)
{
  std::mt19937 random(seed);
  Soup soup = triangulated(grid(420, 170));
  bump(soup, 0.02, random);
  flatten_some(soup, 50, random);
  shuffle_faces(soup, random);
  std::vector<std::size_t> new_of_old;
  shuffle_vertices(soup, random, new_of_old);
  return soup;
}

class Parallel_test : public ::testing::TestWithParam<unsigned>
{
};

TEST_P(Parallel_test, two_step_gives_the_same_bits)
{
  const Surface_mesh mesh = to_surface_mesh(large_sheet(GetParam()));
  ASSERT_GT(num_faces(mesh), 2 * RS::internal::blocks_in_range * RS::internal::block_size);
  for (const auto convexity : {RS::Feature_convexity::CONCAVE, RS::Feature_convexity::ALL}) {
    const Outputs expected = run<CGAL::Sequential_tag>(mesh, RS::Two_step(), convexity);
    for (const std::size_t threads : {1, 2, 5}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      EXPECT_EQ(run<CGAL::Parallel_tag>(mesh, RS::Two_step(), convexity), expected)
          << "seed " << GetParam() << ", " << threads << " threads";
    }
  }
}

/// What is known of every dual edge, and every corner.
template <typename ConcurrencyTag, typename Pack>
std::vector<double> numbers_read(const Surface_mesh& mesh, const Pack& np)
{
  const RS::Flat_mesh flat = RS::internal::read_flat_mesh<ConcurrencyTag>(
    RS::internal::make_mesh_walk(mesh, np), np, RS::Flat_mesh::Content::ANGLES_AND_POINTS);
  std::vector<double> result;
  for (std::size_t e = 0; e < flat.number_of_edges(); ++e)
    result.insert(result.end(), {double(flat.lower_face(e)), double(flat.higher_face(e)), flat.length(e),
                                 double(flat.flags(e)), flat.cosine(flat.lower_face(e), e)});
  for (std::size_t f = 0; f < flat.number_of_faces(); ++f)
    for (std::size_t i = 0; i < flat.number_of_corners(f); ++i)
      result.push_back(flat.corner(f, i));
  return result;
}

TEST_P(Parallel_test, reading_gives_the_same_bits)
{
  const Surface_mesh mesh = to_surface_mesh(large_sheet(GetParam()));
  std::mt19937 random(GetParam());
  std::vector<char> constrained(num_edges(mesh));
  for (char& c : constrained)
    c = random() % 10 == 0;
  const auto np = RS::internal::pack(RS::parameters::edge_is_constrained_map(
    boost::make_iterator_property_map(constrained.begin(), get(boost::edge_index, mesh))));
  const auto expected = numbers_read<CGAL::Sequential_tag>(mesh, np);
  for (const std::size_t threads : {1, 3}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_TRUE(numbers_read<CGAL::Parallel_tag>(mesh, np) == expected)
        << "seed " << GetParam() << ", " << threads << " threads";
  }
}

TEST_P(Parallel_test, best_gives_the_same_bits)
{
  Soup soup = torus(150, 60);
  std::mt19937 random(GetParam());
  bump(soup, 0.01, random);
  const Surface_mesh mesh = to_surface_mesh(soup);
  ASSERT_GT(num_faces(mesh), 2 * RS::internal::block_size);
  EXPECT_EQ(run<CGAL::Parallel_tag>(mesh, RS::Best(), RS::Feature_convexity::CONCAVE),
            run<CGAL::Sequential_tag>(mesh, RS::Best(), RS::Feature_convexity::CONCAVE))
      << "seed " << GetParam();
}

/// The lowest index of each tree, by search.
std::vector<std::uint32_t> labels_by_search(std::size_t size,
                                            const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs)
{
  std::vector<std::vector<std::uint32_t>> neighbors(size);
  for (const auto& [a, b] : pairs) {
    neighbors[a].push_back(b);
    neighbors[b].push_back(a);
  }
  const std::uint32_t none = std::uint32_t(size);
  std::vector<std::uint32_t> labels(size, none), stack;
  std::uint32_t number = 0;
  for (std::uint32_t start = 0; start < size; ++start) {
    if (labels[start] != none)
      continue;
    labels[start] = number;
    stack.assign(1, start);
    while (!stack.empty()) {
      const std::uint32_t i = stack.back();
      stack.pop_back();
      for (std::uint32_t j : neighbors[i])
        if (labels[j] == none) {
          labels[j] = number;
          stack.push_back(j);
        }
    }
    ++number;
  }
  return labels;
}

TEST_P(Parallel_test, the_forest_numbers_components_by_their_lowest_element)
{
  std::mt19937 random(GetParam());
  const std::size_t size = 100000;
  for (const std::size_t number_of_pairs : {size / 4, size / 2, size}) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs(number_of_pairs);
    for (auto& [a, b] : pairs) {
      a = std::uint32_t(random() % size);
      b = std::uint32_t(random() % size);
    }
    RS::internal::Lowest_root_forest forest(size);
    constexpr std::size_t size_of_range = 10000;
    const auto is_within = [&](const auto& pair) { return pair.first / size_of_range == pair.second / size_of_range; };
    tbb::parallel_for(std::size_t(0), size / size_of_range, [&](std::size_t range) {
      for (const auto& pair : pairs)
        if (is_within(pair) && pair.first / size_of_range == range)
          forest.unite(pair.first, pair.second);
    });
    for (const auto& pair : pairs)
      if (!is_within(pair))
        forest.unite(pair.first, pair.second);
    const RS::Region_labels labels = forest.take_labels();
    EXPECT_EQ(labels.of_face, labels_by_search(size, pairs)) << "seed " << GetParam();
    EXPECT_EQ(labels.number_of_regions,
              1 + *std::max_element(labels.of_face.begin(), labels.of_face.end()));
  }
}

TEST(Parallel, the_first_point_that_is_not_finite_is_named)
{
  Surface_mesh mesh = to_surface_mesh(triangulated(grid(120, 120)));
  ASSERT_GT(num_vertices(mesh), 2 * RS::internal::block_size);
  for (const std::size_t v : {14000, 5000, 9000})
    mesh.point(Surface_mesh::Vertex_index(v)) = Surface_mesh::Point(std::nan(""), 0, 0);
  std::vector<std::size_t> labels(num_faces(mesh), 99);
  const auto map = boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
  try {
    RS::segment<CGAL::Parallel_tag>(mesh, map, RS::parameters::number_of_segments(2));
    FAIL() << "a point is not finite";
  } catch (const RS::Invalid_input& error) {
    EXPECT_STREQ(error.what(), "the point of vertex 5000 is not finite");
  }
  EXPECT_EQ(labels, std::vector<std::size_t>(labels.size(), 99));
}

INSTANTIATE_TEST_SUITE_P(seeds, Parallel_test, ::testing::Range(1u, 4u));

} // namespace
