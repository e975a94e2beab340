// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"
#include "stages.h"

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>
#include <CGAL/Region_segmentation/Two_step/grow_regions.h>
#include <CGAL/Region_segmentation/segment.h>

#include <gtest/gtest.h>

namespace grow_regions_test {

namespace RS = CGAL::Region_segmentation;
using RS::Feature_convexity;
using namespace test;

struct Regions
{
  Labels labels;
  std::size_t n;
};

Regions grow(const Soup& soup, const std::set<Edge>& features,
             const std::set<Edge>& constrained = {})
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  auto feature_map = edge_map(mesh, features);
  auto region_map = face_map(mesh);
  Regions result;
  result.n = test::grow_regions(
    mesh, feature_map, region_map,
    RS::parameters::component_links(false).edge_is_constrained_map(edge_map(mesh, constrained)));
  result.labels = labels_of(mesh, region_map);
  return result;
}

// As a method sees them, unless components are kept apart.
TEST(Grow_regions_test, borders_that_coincide_are_edges)
{
  const Soup flat = joined(grid(3, 4), translated(grid(2, 4), 3, 0, 0));
  const Soup bent = mapped(flat, [](const Point& p) {
    return Point{p[0], p[1], p[0] > 3 ? p[0] - 3 : 0.0};
  });
  for (const auto& [soup, number] : {std::make_pair(flat, 1u), std::make_pair(bent, 2u)}) {
    const Surface_mesh mesh = to_surface_mesh(soup);
    auto is_feature = edge_map(mesh);
    auto region_map = face_map(mesh), regions_of_method = face_map(mesh);
    test::detect_feature_edges(mesh, is_feature);
    EXPECT_EQ(test::grow_regions(mesh, is_feature, region_map), number);
    RS::segment(
      mesh, face_map(mesh),
      RS::parameters::number_of_segments(1).method(RS::Two_step()).region_map(regions_of_method));
    EXPECT_EQ(labels_of(mesh, region_map), labels_of(mesh, regions_of_method));
    const auto apart = RS::parameters::component_links(false);
    test::detect_feature_edges(mesh, is_feature, Feature_options(), apart);
    EXPECT_EQ(test::grow_regions(mesh, is_feature, region_map, apart), 2u);
  }
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

TEST(Grow_regions_test, a_mesh_of_degenerate_faces_alone)
{
  const Soup line{{{0, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_EQ(grow(line, {}).n, 1u);
  const Soup point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_EQ(grow(point, {}).n, 1u);
}

/// Those of the reference implementation, with given features.
Labels reference_labels(const Soup& soup, const std::set<Edge>& features,
                        const std::set<Edge>& constrained)
{
  reference::Two_step_options options;
  options.constrained_edges = constrained;
  const reference::Mesh mesh = reference::read_mesh(soup.points, soup.polygons, options);
  std::map<Edge, bool> is_feature;
  for (const auto& [edge, faces] : faces_of_edges(soup))
    is_feature[edge] = faces.size() == 1 || features.count(edge) > 0 || constrained.count(edge) > 0;
  std::size_t number = 0;
  return reference::grow_regions(mesh, is_feature, number);
}

TEST(Grow_regions_test, regions_are_those_of_the_reference)
{
  for_each_random_mesh(all_families, 20, [&](const Soup& given, unsigned seed) {
    Soup soup = given;
    std::mt19937 random(seed);
    const auto features = random_edges(soup, 3, random),
               constrained = random_edges(soup, 9, random);
    soup.points.push_back({1, 2, 3}); // of no face
    EXPECT_EQ(grow(soup, features, constrained).labels,
              reference_labels(soup, features, constrained));
  });
}

TEST(Grow_regions_test, degenerate_faces_of_one_block_alone)
{
  const Soup large = torus(120, 60);
  ASSERT_GT(large.polygons.size(), RS::internal::block_size);
  for (const Soup& soup :
       {joined(cap(), large), joined(large, cap()), translated(joined(large, cap()), 0, 1e5, 0)}) {
    const auto result = grow(soup, {});
    EXPECT_EQ(result.labels, reference_labels(soup, {}, {}));
    EXPECT_EQ(result.n, 3u);
  }
}

//  3-----------2
//  |           |
//  0----4,5----1     the face 0 5 1 4 has no area, and two edges of one length to each neighbor: 0
//  4 and 4 1 above, 0 5 and |           |     5 1 below 6-----------7
TEST(Grow_regions_test, of_equal_edges_to_one_face_the_first_is_joined)
{
  for (bool is_needle_first : {false, true}) {
    Soup soup{
      {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {2, -1, 0}},
      {{0, 4, 1, 2, 3}, {0, 5, 1, 4}, {0, 6, 7, 1, 5}}};
    if (is_needle_first)
      std::swap(soup.polygons[0], soup.polygons[1]);
    for (const std::set<Edge>& features : {std::set<Edge>{{0, 4}},
                                           {{1, 4}},
                                           {{0, 5}},
                                           {{1, 5}},
                                           {{0, 4}, {0, 5}},
                                           {{1, 4}, {0, 5}}}) {
      const auto result = grow(soup, features);
      // The upper face is the lower neighbor. From vertex 0 its boundary begins with 0 4, that of
      // the other face leads over 1 4 before 4 0.
      const Edge joining = is_needle_first ? Edge{0, 4} : Edge{1, 4};
      EXPECT_EQ(result.labels[0] == result.labels[1], features.count(joining) == 0);
    }
  }
}

TEST(Grow_regions_test, one_of_two_coinciding_edges_can_be_the_feature)
{
  const Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, -1, 0}},
                  {{0, 1, 2}, {3, 4, 5}}};
  const Surface_mesh mesh = to_surface_mesh(soup);
  for (const std::set<Edge>& features : {std::set<Edge>{}, {{0, 1}}, {{3, 4}}}) {
    auto is_feature = edge_map(mesh, features);
    EXPECT_EQ(test::grow_regions(mesh, is_feature, face_map(mesh)), features.empty() ? 1u : 2u);
  }
}

} // namespace grow_regions_test
