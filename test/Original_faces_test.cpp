// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces of overlapping scans are one with the faces that they lie on; layers and bodies in contact
// are not.

#include "meshes.h"

#include <CGAL/Region_segmentation/internal/surface/Intrinsic_surface.h>
#include <CGAL/Region_segmentation/internal/surface/Original_faces.h>
#include <CGAL/Region_segmentation/make_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace Original_faces_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;

/// The faces of which the centroid passes, with noise of this amplitude in every coordinate.
template <typename Passes>
Soup scan(const Soup& soup, double noise, unsigned seed, const Passes& passes)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-noise, noise);
  Soup result = soup;
  for (Point& p : result.points)
    p = {p[0] + any(random), p[1] + any(random), p[2] + any(random)};
  result.polygons.clear();
  for (const Polygon& polygon : soup.polygons) {
    Point c = {0, 0, 0};
    for (const std::size_t v : polygon)
      for (std::size_t i = 0; i < 3; ++i)
        c[i] += soup.points[v][i] / double(polygon.size());
    if (passes(c))
      result.polygons.push_back(polygon);
  }
  return result;
}

std::size_t number_of_covered(const Soup& soup)
{
  const RS::internal::Original_faces originals(RS::make_surface(soup.points, soup.polygons));
  std::size_t result = 0;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    result += !originals.is_original(f);
  return result;
}

bool is_anywhere(const Point&)
{
  return true;
}

Soup shifted(const Soup& soup, double z)
{
  return mapped(soup, [&](const Point& p) { return Point{p[0], p[1], p[2] + z}; });
}

TEST(Original_faces_test, a_scan_on_another_one_is_covered)
{
  const Soup ball = sphere(4);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Soup part = scan(ball, 2e-3, seed, [](const Point& p) { return p[2] > 0.2; });
    const Soup both = joined(ball, part);
    const RS::Surface surface = RS::make_surface(both.points, both.polygons);
    const RS::internal::Original_faces originals(surface);
    for (std::size_t f = 0; f < both.polygons.size(); ++f)
      if (f < ball.polygons.size())
        EXPECT_EQ(originals.of[f], f);
      else {
        EXPECT_LT(originals.of[f], ball.polygons.size());
        EXPECT_LT(norm(surface.centroid(f) - surface.centroid(originals.of[f])),
                  0.1); // its edges are 0.07 long
      }
  }
}

// The faces beyond the larger one are sewed to it.
TEST(Original_faces_test, scans_that_overlap_in_part_are_one_component)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Soup ball = sphere(4);
    const Soup upper = scan(ball, 1e-3, seed, [](const Point& p) { return p[2] > -0.4; });
    const Soup lower = scan(ball, 1e-3, seed + 10, [](const Point& p) { return p[2] < 0.4; });
    const Soup both = joined(upper, lower);
    const RS::Surface given = RS::make_surface(both.points, both.polygons);
    const RS::internal::Intrinsic_surface intrinsic(given);
    const RS::Surface& surface = intrinsic.of(given);
    EXPECT_EQ(RS::internal::edge_components(surface, RS::Execution()).number_of_parts(), 1u);
    EXPECT_EQ(surface.number_of_faces() + number_of_covered(both), both.polygons.size());
    // 1.4 of the heights 0 to 2 of the larger, and what it leaves; a row of faces may be twice.
    EXPECT_GT(surface.area() / given.area(), 2 / 2.8 * 0.99);
    EXPECT_LT(surface.area() / given.area(), 2.1 / 2.8);
  }
}

TEST(Original_faces_test, layers_are_not_covered)
{
  const Soup sheet = grid(20, 20);
  const double gap = 0.1; // of a side of 20
  Soup layers = sheet;
  for (int i = 1; i < 5; ++i)
    layers = joined(layers, shifted(sheet, gap * i));
  EXPECT_EQ(number_of_covered(layers), 0u);
  const Soup rough = scan(shifted(sheet, gap), 0.02, 1, is_anywhere);
  EXPECT_EQ(number_of_covered(joined(sheet, rough)), 0u);
  EXPECT_EQ(number_of_covered(joined(sheet, scan(sheet, 0.02, 1, is_anywhere))),
            sheet.polygons.size());
}

TEST(Original_faces_test, a_closed_copy_is_covered)
{
  const Soup box = voxel_surface(voxel_block({0, 0, 0}, {20, 20, 4}));
  EXPECT_EQ(number_of_covered(joined(box, shifted(box, 0.01))), box.polygons.size());
}

TEST(Original_faces_test, bodies_in_contact_are_not_covered)
{
  const Soup box = voxel_surface(voxel_block({0, 0, 0}, {20, 20, 4}));
  const Soup smaller = mapped(voxel_surface(voxel_block({4, 4, 4}, {12, 12, 8})),
                              [](const Point& p) {
                                return Point{p[0] + 0.5, p[1] + 0.5, p[2]}; // without equal points
                              });
  EXPECT_EQ(number_of_covered(joined(box, smaller)), 0u);                 // on it
  EXPECT_EQ(number_of_covered(joined(box, shifted(smaller, -0.05))), 0u); // in it
  const Soup ball = sphere(4);
  const Soup inner = mapped(ball, [](const Point& p) {
    return Point{0.998 * p[0], 0.998 * p[1], 0.998 * p[2]};
  });
  EXPECT_EQ(number_of_covered(joined(ball, inner)), 0u); // a thin wall
  EXPECT_EQ(number_of_covered(
              joined(ball, scan(reversed(ball), 2e-3, 1, [](const Point& p) { return p[2] > 0; }))),
            0u);
}

// The faces of a sheet inside a wall, with opposite normals, in any order.
TEST(Original_faces_test, what_is_opposite_is_not_covered)
{
  const Soup box = voxel_surface(voxel_block({0, 0, 0}, {1, 1, 1}));
  const Soup sheet = reversed(mapped(grid(2, 2), [](const Point& p) {
    return Point{0.25 + p[0] / 4, 0.25 + p[1] / 4, 1};
  }));
  EXPECT_EQ(number_of_covered(joined(box, sheet)), 0u);
  EXPECT_EQ(number_of_covered(joined(sheet, box)), 0u);
}

} // namespace Original_faces_test
