// SPDX-License-Identifier: GPL-3.0-or-later

// Named parameters: chains in any order, packs of CGAL's own, the effect of each parameter.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Support/version.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>
#include <CGAL/Region_segmentation/segment.h>

#include <boost/property_map/function_property_map.hpp>
#include <gtest/gtest.h>

#include <cstdio>

namespace parameters_test {

namespace RS = CGAL::Region_segmentation;
namespace RP = CGAL::Region_segmentation::parameters;
using namespace test;

TEST(Parameters_test, chain_in_any_order)
{
  const Soup soup = dumbbell();
  const Surface_mesh mesh = to_surface_mesh(soup);
  const auto points = get(CGAL::vertex_point, mesh);
  const RS::Two_step two_step = Options(4, reference::Convexity::all, 30).method();
  const Result expected = run(mesh, RP::number_of_segments(4).method(two_step));
  EXPECT_EQ(expected.tree.number_of_regions(), 16u);
  // Ours after CGAL's, CGAL's after ours, twice.
  for (const Result& result :
       {run(mesh, RP::method(two_step).vertex_point_map(points).number_of_segments(4).geom_traits(
                    Kernel())),
        run(mesh, RP::vertex_point_map(points).number_of_segments(4).geom_traits(Kernel()).method(
                    two_step)),
        run(mesh, RP::number_of_segments(4).geom_traits(Kernel()).method(two_step).vertex_point_map(
                    points))}) {
    EXPECT_EQ(result.segments, expected.segments);
    EXPECT_EQ(result.number_of_segments, 4u);
  }
}

TEST(Parameters_test, parameters_of_stages_chain_in_any_order)
{
  const Surface_mesh mesh = to_surface_mesh(dumbbell());
  const auto points = get(CGAL::vertex_point, mesh);
  const auto concave = RS::Feature_convexity::CONCAVE;
  auto map = edge_map(mesh);
  EXPECT_EQ(RS::detect_feature_edges(mesh, map, RP::feature_convexity(concave).maximum_angle(30)),
            8u);
  EXPECT_EQ(RS::detect_feature_edges(
              mesh, map, RP::maximum_angle(30).vertex_point_map(points).feature_convexity(concave)),
            8u);
  EXPECT_EQ(
    RS::detect_feature_edges(
      mesh, map, RP::vertex_point_map(points).feature_convexity(concave).maximum_angle(30.0f)),
    8u);
  EXPECT_EQ(RS::detect_feature_edges(mesh, map, RP::feature_convexity(concave).maximum_angle(120)),
            0u);
}

TEST(Parameters_test, packs_of_cgal_are_taken)
{
  const Surface_mesh mesh = to_surface_mesh(l_shape());
  auto map = edge_map(mesh);
  EXPECT_EQ(RS::detect_feature_edges(mesh, map, CGAL::parameters::maximum_angle(30)), 1u);
  EXPECT_EQ(RS::detect_feature_edges(
              mesh, map,
              CGAL::parameters::vertex_point_map(get(CGAL::vertex_point, mesh)).maximum_angle(120)),
            0u);
}

TEST(Parameters_test, a_pack_can_be_kept_and_used_again)
{
  const Surface_mesh mesh = to_surface_mesh(dumbbell());
  const auto pack = RS::parameters::number_of_segments(2).method(
    Options(2, reference::Convexity::all, 30).method());
  const Labels expected = run(mesh, pack).segments;
  for (int i = 0; i < 2; ++i) {
    const Result result = run(mesh, pack);
    EXPECT_EQ(result.segments, expected);
    EXPECT_EQ(result.number_of_segments, 2u);
    EXPECT_EQ(result.tree.number_of_regions(), 16u) << "those of the method in the pack";
  }
  EXPECT_NE(run(mesh, RS::parameters::number_of_segments(2)).tree.number_of_regions(), 16u);
}

TEST(Parameters_test, the_point_map_of_a_pack_counts_and_not_that_of_the_mesh)
{
  const Surface_mesh mesh = to_surface_mesh(dumbbell());
  const auto flat = boost::make_function_property_map<Surface_mesh::Vertex_index>(
    [&](Surface_mesh::Vertex_index v) {
      return Kernel::Point_3(mesh.point(v).x(), mesh.point(v).y(), 0);
    });
  const auto pack = RP::feature_convexity(RS::Feature_convexity::CONCAVE).maximum_angle(30);
  auto map = edge_map(mesh);
  EXPECT_EQ(RS::detect_feature_edges(mesh, map, pack), 8u);
  EXPECT_EQ(RS::detect_feature_edges(mesh, map, pack.vertex_point_map(flat)), 0u);
  EXPECT_EQ(RS::detect_feature_edges(mesh, map, RP::vertex_point_map(flat).maximum_angle(30)), 0u);
}

TEST(Version_test, the_number_and_the_text_say_the_same)
{
  char text[32];
  std::snprintf(text, sizeof text, "%d.%d.%d", CGAL_REGION_SEGMENTATION_VERSION_NUMBER / 10000,
                CGAL_REGION_SEGMENTATION_VERSION_NUMBER / 100 % 100,
                CGAL_REGION_SEGMENTATION_VERSION_NUMBER % 100);
  EXPECT_STREQ(text, CGAL_REGION_SEGMENTATION_VERSION);
}

TEST(Parameters_test, number_of_segments_is_of_any_integral_type)
{
  const Surface_mesh mesh = to_surface_mesh(dumbbell());
  const RS::Two_step method = Options(1).method();
  for (int k : {1, 2, 3}) {
    auto map = face_map(mesh);
    RS::Merge_tree by_reference, by_wrapper;
    RS::segment(
      mesh, map,
      RS::parameters::number_of_segments(std::size_t(k)).merge_tree(by_reference).method(method));
    const std::size_t n = RS::segment(
      mesh, map,
      RS::parameters::number_of_segments(short(k)).method(method).merge_tree(std::ref(by_wrapper)));
    EXPECT_EQ(n, std::size_t(k));
    EXPECT_EQ(by_reference.merges().size(), 3u - std::size_t(k)) << "of three regions";
    EXPECT_EQ(by_wrapper.merges().size(), by_reference.merges().size());
  }
}

} // namespace parameters_test
