// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/detect_feature_edges.h>
#include <CGAL/Region_segmentation/grow_regions.h>

#include <gtest/gtest.h>

namespace {

namespace RS = CGAL::Region_segmentation;
using RS::Feature_convexity;
using namespace test;

struct Regions
{
  Labels labels;
  std::size_t n;
  std::set<Edge> features; // that remain
};

Regions grow(const Soup& soup, const std::set<Edge>& features,
             const std::set<Edge>& constrained = {})
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  auto feature_map = edge_map(mesh, features);
  auto region_map = face_map(mesh);
  Regions result;
  result.n = RS::grow_regions(mesh, feature_map, region_map,
                              RS::parameters::edge_is_constrained_map(edge_map(mesh, constrained)));
  result.labels = labels_of(mesh, region_map);
  for (const auto& [edge, is_feature] : flags_of(mesh, feature_map))
    if (is_feature)
      result.features.insert(edge);
  return result;
}

std::size_t number_of_regions(const Soup& soup, Feature_convexity convexity)
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  auto feature_map = edge_map(mesh);
  auto region_map = face_map(mesh);
  RS::detect_feature_edges(mesh, feature_map,
                           RS::parameters::feature_convexity(convexity).maximum_angle(30));
  const std::size_t n = RS::grow_regions(mesh, feature_map, region_map);
  EXPECT_TRUE(is_numbered_by_first_face(labels_of(mesh, region_map), n));
  return n;
}

TEST(Grow_regions_test, boxes)
{
  // A convex solid is one region between concave edges; an L, cut at its concave edge, still hangs
  // together around the ends; a box on a plate does not.
  EXPECT_EQ(number_of_regions(cube(), Feature_convexity::ALL), 6u);
  EXPECT_EQ(number_of_regions(cube(), Feature_convexity::CONVEX), 6u);
  EXPECT_EQ(number_of_regions(cube(), Feature_convexity::CONCAVE), 1u);
  EXPECT_EQ(number_of_regions(l_shape(), Feature_convexity::ALL), 8u);
  EXPECT_EQ(number_of_regions(l_shape(), Feature_convexity::CONVEX), 7u);
  EXPECT_EQ(number_of_regions(l_shape(), Feature_convexity::CONCAVE), 1u);
  EXPECT_EQ(number_of_regions(box_on_plate(), Feature_convexity::CONCAVE), 2u);
  EXPECT_EQ(number_of_regions(box_on_plate(), Feature_convexity::ALL), 11u);
  EXPECT_EQ(number_of_regions(dumbbell(), Feature_convexity::CONCAVE), 3u);
  EXPECT_EQ(number_of_regions(dumbbell(), Feature_convexity::ALL), 16u);
  EXPECT_EQ(number_of_regions(grid(4, 2), Feature_convexity::ALL), 1u);
  EXPECT_EQ(number_of_regions(joined(cube(), l_shape()), Feature_convexity::CONCAVE), 2u);
  EXPECT_EQ(number_of_regions(pillow(), Feature_convexity::ALL), 2u);
}

TEST(Grow_regions_test, cuts_a_sheet_and_clears_what_separates_nothing)
{
  //     10-11-12-13-14
  //      | 4| 5| 6| 7|      2-7-12 cuts, 8-9 does not
  //      5--6--7--8--9
  //      | 0| 1| 2| 3|
  //      0--1--2--3--4
  const Soup sheet = grid(4, 2);
  const auto result =
      grow(sheet, {{2, 7}, {7, 12}, {8, 9}}); // borders are not marked: they get set
  EXPECT_EQ(result.labels, (Labels{0, 0, 1, 1, 0, 0, 1, 1}));
  EXPECT_EQ(result.n, 2u);
  EXPECT_TRUE(result.features.count({2, 7}) && result.features.count({7, 12}));
  EXPECT_FALSE(result.features.count({8, 9}));
  EXPECT_EQ(result.features.size(), 2u + 12u);
}

TEST(Grow_regions_test, constrained_edges_are_not_crossed_and_stay)
{
  const Soup sheet = grid(4, 2);
  const auto cut = grow(sheet, {}, {{2, 7}, {7, 12}});
  EXPECT_EQ(cut.n, 2u);
  EXPECT_EQ(cut.features.size(), 2u + 12u);
  const auto half = grow(sheet, {}, {{2, 7}});
  EXPECT_EQ(half.n, 1u);
  EXPECT_TRUE(half.features.count({2, 7}));
}

TEST(Grow_regions_test, a_cap_joins_across_its_longest_edge)
{
  const auto result = grow(cap(), {});
  // 0 and 3 share the long edge; 1 and 2 share 2 3; the cap is closed towards both.
  EXPECT_EQ(result.labels, (Labels{0, 1, 1, 0}));
  // The long edge is constrained: the longest of the others, which are equal: the lower face.
  EXPECT_EQ(grow(cap(), {}, {{0, 1}}).labels, (Labels{0, 0, 0, 1}));
  EXPECT_EQ(grow(cap(), {}, {{0, 1}, {2, 3}}).labels, (Labels{0, 0, 1, 2}));
  // A mark, unlike a constraint, does not make it choose another edge.
  EXPECT_EQ(grow(cap(), {{0, 1}}).labels, (Labels{0, 1, 1, 2}));
}

TEST(Grow_regions_test, a_cap_at_the_border_joins_across_an_inner_edge)
{
  Soup soup = cap();
  soup.polygons.pop_back();
  EXPECT_EQ(grow(soup, {}).n, 1u);
  std::swap(soup.polygons[1], soup.polygons[2]);
  EXPECT_EQ(grow(soup, {{2, 3}}).labels, (Labels{0, 0, 1})) << "equal lengths: the lower face";
}

TEST(Grow_regions_test, a_needle_joins_one_side_of_its_crease)
{
  const auto result = grow(needle_on_crease(), {});
  EXPECT_EQ(result.labels, (Labels{0, 0, 1})) << "equal lengths: the lower face";
}

TEST(Grow_regions_test, a_mesh_of_degenerate_faces_alone)
{
  const Soup line{{{0, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_EQ(grow(line, {}).n, 1u);
  const Soup point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_EQ(grow(point, {}).n, 1u);
}

TEST(Grow_regions_test, an_empty_mesh_and_a_single_face)
{
  EXPECT_EQ(grow(Soup(), {}).n, 0u);
  EXPECT_EQ(grow(grid(1, 1), {}).n, 1u);
}

TEST(Grow_regions_test, regions_are_the_components_between_features)
{
  for (Family family : all_families)
    for (unsigned seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const Soup soup = random_mesh(family, seed);
      std::mt19937 random(seed);
      const auto features = random_edges(soup, 2, random);
      const auto result = grow(soup, features);
      EXPECT_TRUE(is_numbered_by_first_face(result.labels, result.n));
      EXPECT_TRUE(is_connected(soup, result.labels, features));
      for (const auto& [edge, faces] : faces_of_edges(soup))
        EXPECT_EQ(result.features.count(edge) != 0,
                  faces.size() == 1 ||
                      (features.count(edge) && result.labels[faces[0]] != result.labels[faces[1]]));
      for (const auto& [edge, faces] : faces_of_edges(soup))
        if (!has_degenerate_faces(family) && faces.size() == 2 && !features.count(edge)) {
          EXPECT_EQ(result.labels[faces[0]], result.labels[faces[1]]);
        }
    }
}

} // namespace
