// SPDX-License-Identifier: GPL-3.0-or-later

// Named parameters: chains in any order, packs of CGAL's own, the effect of each parameter.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Support/version.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>
#include <CGAL/Region_segmentation/segment.h>

#include <boost/property_map/function_property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
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

/// The feature edges of valleys above 30 degrees, of the surface that parameters make.
template <typename Parameters>
std::size_t number_of_valleys(const Surface_mesh& mesh, const Parameters& np)
{
  const auto marks = RS::detect_feature_edges(RS::make_surface(mesh, np), 30);
  return std::size_t(std::count(marks.begin(), marks.end(), 1));
}

TEST(Parameters_test, packs_of_cgal_are_taken)
{
  const Surface_mesh mesh = to_surface_mesh(l_shape());
  const auto points = get(CGAL::vertex_point, mesh);
  EXPECT_EQ(number_of_valleys(mesh, CGAL::parameters::vertex_point_map(points)), 1u);
}

TEST(Parameters_test, the_point_map_of_a_pack_counts_and_not_that_of_the_mesh)
{
  const Surface_mesh mesh = to_surface_mesh(dumbbell());
  const auto flat = boost::make_function_property_map<Surface_mesh::Vertex_index>(
    [&](Surface_mesh::Vertex_index v) {
      return Kernel::Point_3(mesh.point(v).x(), mesh.point(v).y(), 0);
    });
  EXPECT_EQ(number_of_valleys(mesh, RP::component_links(false)), 8u);
  EXPECT_EQ(number_of_valleys(mesh, RP::component_links(false).vertex_point_map(flat)), 0u);
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
