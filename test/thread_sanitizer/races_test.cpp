// SPDX-License-Identifier: GPL-3.0-or-later

// The loops of Parallel_tag under the thread sanitizer, on a mesh of several ranges of faces
// (parallel_test.cpp has the oracles; it is too large to be compiled once more).

#include "make_mesh.h"
#include "make_triangles.h"

#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>

#include <CGAL/tags.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <thread>
#include <vector>

namespace {

namespace RS = CGAL::Region_segmentation;
using speed_benchmark::Mesh;

using Labels = std::vector<std::uint32_t>;

auto map_of(const Mesh& mesh, Labels& labels)
{
  labels.resize(num_faces(mesh));
  return boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh));
}

/// With a crease at every edge, and every tenth edge constrained.
struct Races_test : ::testing::Test
{
  const Mesh mesh = speed_benchmark::make_mesh(roughened(speed_benchmark::wavy_torus(140000), 0.2));
  std::vector<char> constrained = std::vector<char>(num_edges(mesh));

  Races_test()
  {
    std::mt19937 random(1);
    for (char& c : constrained)
      c = random() % 10 == 0;
  }

  template <typename ConcurrencyTag, typename Method>
  Labels segments(const Method& method)
  {
    Labels labels;
    const auto constraints = boost::make_iterator_property_map(constrained.begin(),
                                                               get(CGAL::edge_index, mesh));
    RS::segment<ConcurrencyTag>(
      mesh, map_of(mesh, labels),
      RS::parameters::number_of_segments(8).method(method).edge_is_constrained_map(constraints));
    return labels;
  }
};

TEST_F(Races_test, two_step)
{
  ASSERT_GT(num_faces(mesh), 2 * RS::internal::blocks_in_range * RS::internal::block_size);
  EXPECT_EQ(segments<CGAL::Parallel_tag>(RS::Two_step()),
            segments<CGAL::Sequential_tag>(RS::Two_step()));
}

TEST_F(Races_test, learned)
{
  const RS::Learned_merging method;
  EXPECT_EQ(segments<CGAL::Parallel_tag>(method), segments<CGAL::Sequential_tag>(method));
}

TEST_F(Races_test, a_segmenter_asked_from_several_threads)
{
  const RS::Segmenter segmenter(mesh);
  std::vector<Labels> labels(8), expected(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < labels.size(); ++i)
    threads.emplace_back([&, i] { segmenter.segment(map_of(mesh, labels[i]), 2 + i); });
  for (std::thread& thread : threads)
    thread.join();
  for (std::size_t i = 0; i < labels.size(); ++i)
    segmenter.segment(map_of(mesh, expected[i]), 2 + i);
  EXPECT_EQ(labels, expected);
}

} // namespace
