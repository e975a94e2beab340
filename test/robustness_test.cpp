// SPDX-License-Identifier: GPL-3.0-or-later

// Errors of maps leave what is promised, and nothing is done that grows with the size of a mesh in
// vain. (properties_test.cpp: whatever the coordinates and the labels.) Also compiled with
// sanitizers.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/segment.h>

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <vector>

namespace robustness_test {

namespace RS = CGAL::Region_segmentation;
namespace RP = CGAL::Region_segmentation::parameters;
using namespace test;

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
  const RS::Requested_regions requested = RS::requested_regions(
    surface, RS::Partition::into_single_elements(surface.number_of_faces()), RS::Seeds());
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
