// SPDX-License-Identifier: GPL-3.0-or-later

// Preconditions in checked builds: what a program does wrong is told, and outputs stay as they
// were.

#undef NDEBUG

#include "meshes.h"

#include <CGAL/assertions_behaviour.h>
#include <CGAL/region_segmentation.h>

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

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
      : mesh(test::to_surface_mesh(test::cube())),
        labels(mesh.add_property_map<Surface_mesh::Face_index, int>("f:label", 77).first),
        features(mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:feature", true).first),
        old_behaviour(CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION)),
        old_handler(
            CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}))
  {
  }

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
  EXPECT_THROW(RS::segment(mesh, labels, RP::number_of_segments(0).edge_is_feature_map(features)),
               Precondition_exception);
}

TEST_F(Debug_checks_test, maximum_angle_is_between_0_and_180)
{
  for (double angle : {-0.001, 180.001, std::nan("")}) {
    EXPECT_THROW(RS::segment(mesh, labels, RP::number_of_segments(2).maximum_angle(angle)),
                 Precondition_exception);
    EXPECT_THROW(RS::detect_feature_edges(mesh, features, RP::maximum_angle(angle)),
                 Precondition_exception);
  }
}

TEST_F(Debug_checks_test, index_maps_stay_within_the_size)
{
  std::map<Surface_mesh::Face_index, std::size_t> far;
  for (auto f : faces(mesh))
    far[f] = std::size_t(f) + 3;
  // CGAL's own check of index maps comes first in its checked builds, as an assertion.
  EXPECT_THROW(
      RS::segment(mesh, labels,
                  RP::number_of_segments(2).face_index_map(boost::make_assoc_property_map(far))),
      CGAL::Failure_exception);
}

TEST_F(Debug_checks_test, region_ids_are_dense)
{
  for (int bad : {-1, 6, 1000}) {
    auto map =
        mesh.add_property_map<Surface_mesh::Face_index, int>("f:" + std::to_string(bad), 0).first;
    map[Surface_mesh::Face_index(3)] = bad;
    EXPECT_THROW(RS::build_region_adjacency_graph(mesh, map), Precondition_exception);
  }
}

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

TEST_F(Debug_checks_test, a_tree_takes_the_lower_region_first)
{
  RS::Merge_tree tree(3);
  EXPECT_THROW(tree.push_back({1, 0, 0}), Precondition_exception);
  EXPECT_THROW(tree.push_back({1, 1, 0}), Precondition_exception);
  EXPECT_THROW(tree.push_back({1, 3, 0}), Precondition_exception);
  EXPECT_TRUE(tree.merges().empty());
}

TEST(Checked_build_test, right_use_passes)
{
  for (test::Family family : test::all_families) {
    const Surface_mesh mesh = test::to_surface_mesh(test::random_mesh(family, 3));
    auto map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
    EXPECT_GE(RS::segment(mesh, map,
                          RP::number_of_segments(3).feature_convexity(RS::Feature_convexity::ALL)),
              1u);
  }
}

} // namespace
