// SPDX-License-Identifier: GPL-3.0-or-later

// Preconditions in checked builds: violations are reported, and outputs are unchanged.

#undef NDEBUG

#include "meshes.h"

#include <CGAL/assertions_behaviour.h>
#include <CGAL/region_segmentation.h>
#include <CGAL/region_segmentation_stages.h>

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#ifdef CGAL_NO_PRECONDITIONS
#error "this file is about CGAL's preconditions"
#endif

namespace {

namespace RS = CGAL::Region_segmentation;
namespace RP = CGAL::Region_segmentation::parameters;
using CGAL::Precondition_exception;
using test::Surface_mesh;

struct Debug_checks_test : ::testing::Test
{
  Debug_checks_test()
    : mesh(test::to_surface_mesh(test::cube()))
    , labels(mesh.add_property_map<Surface_mesh::Face_index, int>("f:label", 77).first)
    , features(mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:feature", true).first)
    , old_behaviour(CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION))
    , old_handler(
        CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}))
  {}

  ~Debug_checks_test() override
  {
    CGAL::set_error_handler(old_handler);
    CGAL::set_error_behaviour(old_behaviour);
    for (auto f : faces(mesh))
      EXPECT_EQ(labels[f], 77);
    for (auto e : edges(mesh))
      EXPECT_TRUE(features[e]);
  }

  Surface_mesh mesh;
  Surface_mesh::Property_map<Surface_mesh::Face_index, int> labels;
  Surface_mesh::Property_map<Surface_mesh::Edge_index, bool> features;
  CGAL::Failure_behaviour old_behaviour;
  CGAL::Failure_function old_handler;
};

TEST_F(Debug_checks_test, number_of_segments_is_at_least_one)
{
  EXPECT_THROW(RS::segment(mesh, labels, RP::number_of_segments(0)), Precondition_exception);
}

TEST_F(Debug_checks_test, maximum_angle_is_between_0_and_180)
{
  for (double angle : {-0.001, 180.001, std::nan("")})
    EXPECT_THROW(RS::detect_feature_edges(RS::make_surface(mesh), angle), Precondition_exception);
}

TEST_F(Debug_checks_test, a_segmenter_gives_at_least_one_segment)
{
  const RS::Segmenter segmenter(mesh);
  EXPECT_THROW(segmenter.segment(labels, 0), Precondition_exception);
  EXPECT_THROW(segmenter.segment(labels, -1), Precondition_exception);
  EXPECT_THROW(RS::Segmenter(mesh, RP::number_of_segments(0)), Precondition_exception);
}

TEST_F(Debug_checks_test, partitions_are_numbered_by_their_first_elements)
{
  using Numbers = std::vector<int>;
  EXPECT_EQ(RS::Partition(Numbers{0, 1, 0, 2}, 3).size(), 4u);
  EXPECT_THROW(RS::Partition(Numbers{0, 1, 0, 3}, 3), Precondition_exception) << "too high";
  EXPECT_THROW(RS::Partition(Numbers{0, 2, 1}, 3), Precondition_exception) << "in another order";
  EXPECT_THROW(RS::Partition(Numbers{0, 1, 0}, 3), Precondition_exception) << "one is empty";
}

TEST_F(Debug_checks_test, composed_partitions_fit)
{
  const auto fine = RS::Partition::from_labels(std::vector<int>{0, 1, 0});
  EXPECT_THROW(composed(fine, RS::Partition::from_labels(std::vector<int>{0})),
               Precondition_exception);
  EXPECT_EQ(composed(fine, RS::Partition::from_labels(std::vector<int>{0, 0})).number_of_parts(),
            1u);
}

TEST_F(Debug_checks_test, index_maps_have_different_values)
{
  std::map<Surface_mesh::Face_index, std::size_t> equal;
  for (auto f : faces(mesh))
    equal[f] = 3;
  EXPECT_THROW(
    RS::segment(mesh, labels,
                RP::number_of_segments(2).face_index_map(boost::make_assoc_property_map(equal))),
    CGAL::Precondition_exception);
}

// Labels of regions need not be dense: see Region_adjacency_graph_test.cpp.

TEST_F(Debug_checks_test, the_graph_refuses_what_is_not_there)
{
  RS::Region_adjacency_graph<> g;
  for (int i = 0; i < 3; ++i)
    g.add_region();
  const auto a = g.add_section(0, 1), b = g.add_section(1, 2);
  EXPECT_THROW(g.add_section(0, 1), Precondition_exception) << "twice";
  EXPECT_THROW(g.add_section(1, 0), Precondition_exception) << "twice";
  EXPECT_THROW(g.add_section(2, 2), Precondition_exception) << "a loop";
  g.forbid_merge(b);
  EXPECT_THROW(g.merge(b), Precondition_exception);
  g.merge(a);
  EXPECT_THROW(g.merge(a), Precondition_exception) << "it is gone";
  EXPECT_THROW(g.add_section(1, 2), Precondition_exception) << "1 is gone";
  EXPECT_EQ(g.number_of_regions(), 2u);
  EXPECT_EQ(g.number_of_sections(), 1u);
}

TEST(Checked_build_test, right_use_passes)
{
  RS::Two_step all_edges;
  all_edges.feature_convexity = RS::Feature_convexity::ALL;
  for (test::Family family : test::all_families) {
    const Surface_mesh mesh = test::to_surface_mesh(test::random_mesh(family, 3));
    auto map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
    EXPECT_GE(RS::segment(mesh, map, RP::number_of_segments(3).method(all_edges)), 1u);
    EXPECT_GE(RS::segment(mesh, map), 1u);
    EXPECT_GE(RS::segment(mesh, map, RP::number_of_segments(3)), 1u);
    EXPECT_GE(RS::segment(mesh, map, RP::number_of_segments(1000000)), 1u);
  }
  const Surface_mesh empty;
  auto none = get(CGAL::dynamic_face_property_t<std::size_t>(), empty);
  EXPECT_EQ(RS::segment(empty, none), 0u);
  EXPECT_EQ(RS::Segmenter(empty).segment(none), 0u);
}

} // namespace
