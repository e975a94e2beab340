// SPDX-License-Identifier: GPL-3.0-or-later

// Parallel_tag gives the same bits as Sequential_tag.

#include "meshes.h"
#include "stages.h"

#include <CGAL/region_segmentation.h>
#include <CGAL/region_segmentation_stages.h>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <random>
#include <thread>
#include <type_traits>
#include <vector>

namespace parallel_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;

struct Outputs
{
  std::size_t number_of_segments;
  std::vector<std::size_t> segments, regions;
  std::vector<double> costs;

  bool operator==(const Outputs& other) const
  {
    return number_of_segments == other.number_of_segments && segments == other.segments &&
           regions == other.regions && costs == other.costs;
  }
};

auto by_face(const Surface_mesh& mesh, std::vector<std::size_t>& values)
{
  values.resize(num_faces(mesh));
  return boost::make_iterator_property_map(values.begin(), get(boost::face_index, mesh));
}

template <typename ConcurrencyTag, typename Parameters>
Outputs run(const Surface_mesh& mesh, const Parameters& np)
{
  Outputs result;
  RS::Merge_tree tree;
  result.number_of_segments = RS::segment<ConcurrencyTag>(
    mesh, by_face(mesh, result.segments),
    np.region_map(by_face(mesh, result.regions)).merge_tree(std::ref(tree)));
  for (const auto& merge : tree.merges())
    result.costs.push_back(merge.cost);
  return result;
}

RS::Two_step two_step(RS::Feature_convexity convexity)
{
  RS::Two_step method;
  method.maximum_angle = 3;
  method.feature_convexity = convexity;
  return method;
}

/// The feature edges that remain, by the stage functions.
template <typename ConcurrencyTag>
std::vector<bool> features(const Surface_mesh& mesh, RS::Feature_convexity convexity)
{
  std::vector<bool> result(num_edges(mesh));
  std::vector<std::size_t> regions;
  const auto map = boost::make_iterator_property_map(result.begin(), get(boost::edge_index, mesh));
  test::detect_feature_edges<ConcurrencyTag>(mesh, map, test::Feature_options{3, convexity});
  test::grow_regions<ConcurrencyTag>(mesh, map, by_face(mesh, regions));
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
{};

TEST_P(Parallel_test, two_step_gives_the_same_bits)
{
  const Surface_mesh mesh = to_surface_mesh(large_sheet(GetParam()));
  ASSERT_GT(num_faces(mesh), 2 * RS::internal::blocks_in_range * RS::internal::block_size);
  for (const auto convexity : {RS::Feature_convexity::CONCAVE, RS::Feature_convexity::ALL}) {
    const auto np = RS::parameters::number_of_segments(7).method(two_step(convexity));
    const Outputs expected = run<CGAL::Sequential_tag>(mesh, np);
    const auto expected_features = features<CGAL::Sequential_tag>(mesh, convexity);
    for (const std::size_t threads : {1, 2, 5}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      EXPECT_EQ(run<CGAL::Parallel_tag>(mesh, np), expected)
        << "seed " << GetParam() << ", " << threads << " threads";
      EXPECT_EQ(features<CGAL::Parallel_tag>(mesh, convexity), expected_features)
        << "seed " << GetParam() << ", " << threads << " threads";
    }
  }
}

static_assert(std::is_constructible<RS::Execution, CGAL::Parallel_tag>::value &&
                !std::is_constructible<RS::Execution, int>::value,
              "an execution is made of a concurrency tag");

/// Inside out, so that it is turned.
Surface_mesh bumpy_torus(unsigned seed)
{
  Soup soup = torus(150, 60);
  std::mt19937 random(seed);
  bump(soup, 0.01, random);
  return to_surface_mesh(reversed(soup));
}

TEST_P(Parallel_test, the_default_method_gives_the_same_bits)
{
  for (const Surface_mesh& mesh :
       {bumpy_torus(GetParam()), to_surface_mesh(large_sheet(GetParam()))}) {
    ASSERT_GT(num_faces(mesh), 2 * RS::internal::block_size);
    const auto np = RS::parameters::number_of_segments(7);
    tbb::task_arena arena(3);
    EXPECT_TRUE(arena.execute([&] { return run<CGAL::Parallel_tag>(mesh, np); }) ==
                run<CGAL::Sequential_tag>(mesh, np))
      << "seed " << GetParam();
  }
}

TEST_P(Parallel_test, smoothed_borders_are_the_same)
{
  const Surface_mesh mesh = bumpy_torus(GetParam());
  std::vector<std::size_t> in_sequence, in_parallel;
  RS::segment(mesh, by_face(mesh, in_sequence), RS::parameters::number_of_segments(7));
  in_parallel = in_sequence;
  const auto map_of = [&](std::vector<std::size_t>& values) {
    return boost::make_iterator_property_map(values.begin(), get(CGAL::face_index, mesh));
  };
  EXPECT_GT(RS::smooth_borders(mesh, map_of(in_sequence)), 0u);
  RS::smooth_borders<CGAL::Parallel_tag>(mesh, map_of(in_parallel));
  EXPECT_EQ(in_parallel, in_sequence);
}

TEST_P(Parallel_test, a_segmenter_gives_the_same_labels)
{
  const Surface_mesh mesh = bumpy_torus(GetParam());
  const RS::Segmenter parallel(mesh, RS::parameters::default_values(), CGAL::Parallel_tag());
  const RS::Segmenter sequential(mesh);
  for (std::size_t k : {2, 7, 1000}) {
    std::vector<std::size_t> a, b;
    parallel.segment(by_face(mesh, a), k);
    sequential.segment(by_face(mesh, b), k);
    EXPECT_EQ(a, b) << "seed " << GetParam() << ", k " << k;
  }
}

/// Counts its calls by other threads than the one that made it.
struct Thread_visitor
{
  std::thread::id caller = std::this_thread::get_id();
  std::size_t calls = 0, others = 0;

  bool on_progress(const char*, double)
  {
    ++calls;
    others += std::this_thread::get_id() != caller;
    return true;
  }
};

TEST(Parallel, a_visitor_is_called_by_the_calling_thread_alone)
{
  const Surface_mesh mesh = bumpy_torus(1);
  Thread_visitor visitor;
  std::vector<std::size_t> labels;
  RS::segment<CGAL::Parallel_tag>(mesh, by_face(mesh, labels),
                                  RS::parameters::number_of_segments(7).visitor(std::ref(visitor)));
  EXPECT_GT(visitor.calls, 0u);
  EXPECT_EQ(visitor.others, 0u);
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

} // namespace parallel_test
