// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Region_segmentation/choose_feature_convexity.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace {

namespace RS = CGAL::Region_segmentation;
using RS::Feature_convexity;
using namespace test;

RS::Feature_convexity_choice choice(const Soup& soup)
{
  return RS::choose_feature_convexity(to_surface_mesh(soup));
}

/// A block of squares of 1, and a cube on it.
Soup block()
{
  std::vector<Voxel> voxels = voxel_block({0, 0, 0}, {6, 6, 3});
  voxels.push_back({3, 3, 3});
  return triangulated(voxel_surface(voxels));
}

TEST(Choose_feature_convexity_test, all_edges_where_everything_but_the_creases_is_flat)
{
  for (const Soup& soup : {block(), cube(), voxel_surface(voxel_block({0, 0, 0}, {4, 4, 4})),
                           triangulated(cube()), triangulated(box_on_plate())}) {
    EXPECT_EQ(choice(soup).convexity, Feature_convexity::ALL);
    EXPECT_EQ(choice(soup).flatness_beside_creases, 1);
  }
}

TEST(Choose_feature_convexity_test, concave_edges_where_there_is_no_crease)
{
  for (const Soup& soup : {sphere(4), torus(40, 30), triangulated(grid(5, 4))}) {
    EXPECT_EQ(choice(soup).convexity, Feature_convexity::CONCAVE);
    EXPECT_EQ(choice(soup).flatness_beside_creases, 0);
  }
}

TEST(Choose_feature_convexity_test, concave_edges_where_the_surface_bends_beside_its_creases)
{
  // The flat ellipsoid has creases along its rim.
  const Soup pinched = mapped(sphere(4), [](const Point& p) {
    return Point{p[0], p[1] * 0.2, p[2]};
  });
  const RS::Feature_convexity_choice result = choice(pinched);
  EXPECT_EQ(result.convexity, Feature_convexity::CONCAVE);
  EXPECT_LT(result.flatness_beside_creases, 0.5);
}

TEST(Choose_feature_convexity_test, noise_above_the_bound_makes_a_machine_part_a_scan)
{
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  Soup noisy = block();
  bump(noisy, 0.15, random);
  EXPECT_EQ(choice(noisy).convexity, Feature_convexity::CONCAVE);
  const auto tolerant = RS::choose_feature_convexity(to_surface_mesh(noisy),
                                                     RS::parameters::maximum_angle(30));
  EXPECT_EQ(tolerant.convexity, Feature_convexity::ALL);
  EXPECT_EQ(tolerant.flatness_beside_creases, 1);
}

TEST(Choose_feature_convexity_test, is_the_same_in_any_place_size_orientation_and_order)
{
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  Soup soup = block();
  bump(soup, 0.01, random);
  const RS::Feature_convexity_choice before = choice(soup);
  EXPECT_GT(before.flatness_beside_creases, 0);
  EXPECT_LT(before.flatness_beside_creases, 1);
  Soup shuffled = soup;
  shuffle_faces(shuffled, random);
  for (const Soup& same : {shuffled, reversed(soup), scaled(soup, 1024), translated(soup, 8, -16, 4)}) {
    const RS::Feature_convexity_choice after = choice(same);
    EXPECT_EQ(after.convexity, before.convexity);
    EXPECT_NEAR(after.flatness_beside_creases, before.flatness_beside_creases, 1e-9);
  }
}

TEST(Choose_feature_convexity_test, degenerate_faces_do_not_count)
{
  for (unsigned seed : {1u, 2u, 3u}) {
    const double share =
        choice(random_mesh(Family::DEGENERATE_SHEET, seed)).flatness_beside_creases;
    EXPECT_GE(share, 0);
    EXPECT_LE(share, 1);
  }
}

TEST(Choose_feature_convexity_test, a_point_that_is_not_finite_is_an_error)
{
  Soup soup = cube();
  soup.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(choice(soup), RS::Invalid_input);
}

} // namespace
