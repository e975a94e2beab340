// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Region_segmentation/Surface/internal/smooth_noise.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace smooth_noise_test {

RS::Surface surface_of(const Soup& soup)
{
  return RS::make_surface_of_polygon_soup(soup.points, soup.polygons);
}

bool have_equal_points(const RS::Surface& a, const RS::Surface& b)
{
  return std::equal(a.points().begin(), a.points().end(), b.points().begin(), b.points().end(),
                    [](const auto& p, const auto& q) { return norm(p - q) == 0; });
}

RS::Surface smooth_noise(const RS::Surface& surface)
{
  return RS::internal::without_noise(surface, RS::Execution());
}

TEST(smooth_noise_test, leaves_what_has_no_noise)
{
  const Soup block = voxel_surface(voxel_block({0, 0, 0}, {9, 3, 3}));
  for (const Soup& soup :
       {sphere(2), sphere(5), torus(30, 12), block, triangulated(block), needle_on_crease()}) {
    SCOPED_TRACE(std::to_string(soup.polygons.size()) + " faces");
    const RS::Surface surface = surface_of(soup);
    EXPECT_TRUE(have_equal_points(smooth_noise(surface), surface));
  }
  EXPECT_EQ(smooth_noise(RS::Surface()).number_of_faces(), 0u);
}

// All that depends on points is as if the surface had been made of them, but for lengths.
TEST(smooth_noise_test, gives_the_surface_of_the_moved_points)
{
  Soup soup = with_noise(joined(sphere(5), translated(torus(60, 24), 8, 0, 0)), 0.01, 7);
  soup.polygons.push_back(soup.polygons[3]); // given twice: degenerate
  const RS::Surface surface = surface_of(soup);
  const RS::Surface smoothed = smooth_noise(surface);
  ASSERT_FALSE(have_equal_points(smoothed, surface));
  Soup moved = soup;
  for (std::size_t v = 0; v < moved.points.size(); ++v)
    moved.points[v] = {smoothed.point(v).x, smoothed.point(v).y, smoothed.point(v).z};
  const RS::Surface expected = surface_of(moved);
  EXPECT_NEAR(smoothed.area(), expected.area(), 1e-12 * expected.area());
  ASSERT_EQ(smoothed.number_of_adjacencies(), expected.number_of_adjacencies());
  for (std::size_t f = 0; f < expected.number_of_faces(); ++f) {
    EXPECT_EQ(smoothed.is_degenerate(f), expected.is_degenerate(f));
    EXPECT_NEAR(smoothed.area(f), expected.area(f), 1e-12);
    EXPECT_LT(norm(smoothed.normal(f) - expected.normal(f)), 1e-9);
  }
  for (std::size_t a = 0; a < expected.number_of_adjacencies(); ++a) {
    EXPECT_EQ(smoothed.flags(a), expected.flags(a)) << a;
    EXPECT_EQ(smoothed.squared_length(a), surface.squared_length(a)) << a;
  }
}

} // namespace smooth_noise_test
