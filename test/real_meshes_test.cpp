// SPDX-License-Identifier: GPL-3.0-or-later

// Invariants on real meshes: those that come with CGAL's demos, unpacked by test/run.sh to a folder
// that the environment variable REGION_SEGMENTATION_REAL_MESHES names.

#include "meshes.h"
#include "oracles.h"
#include "real_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace real_meshes_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;

void check(const Surface_mesh& mesh)
{
  const Soup soup = soup_of(mesh);
  for (const auto& options : {Options(8), Options(5, reference::Convexity::all, 30),
                              Options(1, reference::Convexity::convex, 10)}) {
    const Result result = run(mesh, options);
    const std::size_t regions = result.tree.number_of_regions();
    EXPECT_TRUE(is_numbered_by_first_face(result.segments, result.number_of_segments));
    EXPECT_TRUE(is_numbered_by_first_face(result.regions, regions));
    EXPECT_TRUE(is_connected(soup, result.regions));
    EXPECT_TRUE(is_connected(soup, result.segments));
    EXPECT_TRUE(nests(result.regions, result.segments));
    EXPECT_EQ(result.number_of_segments,
              (std::min)(regions, (std::max)(options.k, number_of_components(soup))));
  }
}

TEST(Real_meshes, keep_the_invariants)
{
  check_real_meshes(100000, [](const Surface_mesh& mesh) {
    check(mesh);
    return true;
  });
}

TEST(Real_meshes, agree_with_the_reference_where_they_are_small)
{
  check_real_meshes(8000, [](const Surface_mesh& mesh) {
    const Soup soup = soup_of(mesh);
    const Options options(8, reference::Convexity::all, 20); // whichever side is out
    try {
      const auto expected = reference::two_step(soup.points, soup.polygons, options);
      EXPECT_EQ(run(mesh, options).regions, expected.region_id);
      return true;
    } catch (const std::invalid_argument&) {
      return false; // two edges between the same vertices, which the reference does not know
    }
  });
}

} // namespace real_meshes_test
