// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"
#include "superfacet_stages.h"

#include <CGAL/Region_segmentation/Superfacets/Superfacets.h>
#include <CGAL/Region_segmentation/Two_step/grow_regions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace Superfacets_test {

TEST(Superfacets_test, are_connected_and_as_many_as_are_asked_for)
{
  for (Family family : {Family::SHEET, Family::SPHERE, Family::TORUS, Family::BLOCKS})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const Soup soup = random_mesh(family, seed);
      const RS::Partition regions = superfacets_of(surface_of_soup(soup), RS::Superfacets(12));
      EXPECT_TRUE(is_numbered_by_first_face(labels_of(regions), 12));
      EXPECT_TRUE(is_connected(soup, labels_of(regions)));
    }
}

/// Seeds are far apart: in a flat sheet of unit squares, no face is farther from the centroid of
/// its superfacet than twice the side of a square of its area.
TEST(Superfacets_test, are_compact)
{
  const RS::Surface sheet = surface_of_soup(grid(24, 24));
  const RS::Partition regions = superfacets_of(sheet, RS::Superfacets(16));
  std::vector<RS::Double_3> sums(16);
  std::vector<double> areas(16);
  for (std::size_t f = 0; f < regions.size(); ++f) {
    sums[regions[f]] = sums[regions[f]] + sheet.centroid(f);
    ++areas[regions[f]];
  }
  for (std::size_t f = 0; f < regions.size(); ++f)
    EXPECT_LT(norm(sheet.centroid(f) - 1 / areas[regions[f]] * sums[regions[f]]),
              2 * std::sqrt(areas[regions[f]]));
  EXPECT_LT(*std::max_element(areas.begin(), areas.end()), 4 * 36);
  EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 36. / 4);
}

TEST(Superfacets_test, seeds_of_crumbs_do_not_count)
{
  const Soup body = random_mesh(Family::SPHERE, 1), crumb = scaled(cube(), 0.001);
  const RS::Partition expected = superfacets_of(surface_of_soup(body), RS::Superfacets(20)),
                      regions = superfacets_of(
                        surface_of_soup(joined(body, translated(crumb, 20, 0, 0))),
                        RS::Superfacets(20));
  ASSERT_EQ(expected.number_of_parts(), 20u);
  EXPECT_EQ(regions.number_of_parts(), 21u);
  for (std::size_t f = 0; f < regions.size(); ++f)
    EXPECT_EQ(regions[f], f < expected.size() ? expected[f] : 20u);
}

TEST(Superfacets_test, of_patches_at_one_distance_the_lower_one_is_first)
{
  // Three squares in a row: both ends are seeds, and the middle belongs to the first one, face 0.
  const RS::Partition regions = superfacets_of(surface_of_soup(grid(3, 1)), RS::Superfacets(2));
  EXPECT_EQ(labels_of(regions), (Labels{0, 0, 1}));
}

TEST(Superfacets_test, there_are_no_more_regions_than_faces)
{
  EXPECT_EQ(superfacets_of(surface_of_soup(cube()), RS::Superfacets(800)).number_of_parts(), 6u);
  EXPECT_EQ(superfacets_of(surface_of_soup(Soup()), RS::Superfacets(800)).number_of_parts(), 0u);
}

TEST(Superfacets_test, a_concave_line_is_a_border)
{
  const RS::Surface mesh = surface_of_soup(box_on_plate());
  EXPECT_EQ(superfacets_of(mesh, RS::Superfacets(2, 50)),
            RS::grow_regions(mesh, RS::detect_feature_edges(mesh, 10)));
}

// Centroids of slivers whose steps differ by more than double can add: rounding hides that a seed
// is nearer.
TEST(Superfacets_test, regions_of_slivers_are_connected)
{
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Soup soup = triangulated(grid(30, 12));
    // Columns from 1 to 1e-20 wide, in turn.
    for (Point& p : soup.points) {
      const auto column = std::size_t(p[0]);
      p[0] = 0;
      for (std::size_t i = 0; i < column; ++i)
        p[0] += i % 3 == 0 ? 1.0 : i % 3 == 1 ? 1e-12 : 1e-20;
    }
    shuffle_faces(soup, random);
    const RS::Superfacets superfacets(3 + seed);
    const RS::Partition regions = superfacets_of(surface_of_soup(soup), superfacets);
    EXPECT_TRUE(is_connected(soup, labels_of(regions)));
  }
}

// The area of the surface is that of one tiny face, so that steps between the others are longer
// than any float.
TEST(Superfacets_test, regions_are_connected_where_steps_are_longer_than_a_float)
{
  Soup soup;
  soup.points = {{0, 0, 0},   {1e-60, 0, 0}, {0, 1e-60, 0}, {1, 0, 0},
                 {1.5, 0, 0}, {1.7, 0, 0},   {1.2, 0, 0},   {1.9, 0, 0}};
  soup.polygons = {{0, 1, 2}, {3, 4, 5}, {4, 3, 6}, {5, 4, 7}};
  const RS::Surface mesh = surface_of_soup(soup);
  const RS::Surface_patches faces = RS::internal::Patch_builder::build(mesh, 4, RS::Execution());
  const RS::Partition regions = RS::Superfacets(3)(mesh, faces); // each face is a patch
  EXPECT_EQ(regions.number_of_parts(), 3u + mesh.number_of_crumbs());
  EXPECT_TRUE(is_connected(soup, labels_of(regions)));
}

} // namespace Superfacets_test
