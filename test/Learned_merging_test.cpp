// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/internal/Patch_builder.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/segment.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace Learned_merging_test {

Labels segment_into(const Soup& soup, std::size_t k)
{
  return segments_of(to_surface_mesh(soup), RS::parameters::number_of_segments(k));
}

Labels segment_automatically(const Soup& soup)
{
  return segments_of(to_surface_mesh(soup), RS::parameters::method(RS::Learned_merging()));
}

std::size_t number_of(const Labels& labels)
{
  return 1 + *std::max_element(labels.begin(), labels.end());
}

TEST(Learned_merging_test, each_segment_has_a_face_that_is_neither_degenerate_nor_doubled)
{
  Soup soup = triangulated(cube());
  soup.polygons.push_back(soup.polygons[3]); // doubled
  soup.polygons.push_back({soup.polygons[5][0], soup.polygons[5][2], soup.polygons[5][1]});
  soup.polygons.push_back({0, 1, 1}); // degenerate
  soup.polygons.push_back({2, 2, 2});
  constexpr std::size_t proper = 12;
  for (std::size_t k = 1; k <= 20; ++k) {
    RS::Polygon_soup_segmenter segmenter(soup.points, soup.polygons,
                                         RS::parameters::number_of_segments(k));
    std::vector<std::size_t> labels(soup.polygons.size()), again(labels.size());
    const std::size_t expected = std::min(k, proper);
    EXPECT_EQ(RS::segment_polygon_soup(soup.points, soup.polygons, labels,
                                       RS::parameters::number_of_segments(k)),
              expected);
    EXPECT_EQ(segmenter.segment(again, k), expected);
    EXPECT_EQ(labels, again);
    EXPECT_EQ(std::set<std::size_t>(labels.begin(), labels.begin() + proper).size(), expected);
    EXPECT_EQ(labels[proper], labels[3]);
    EXPECT_EQ(labels[proper + 1], labels[5]);
  }
}

/// Gives as many segments as are asked for, for a list of numbers up to that of the proper faces.
void expect_every_number(const Soup& soup)
{
  const RS::Surface surface = RS::make_surface_of_polygon_soup(soup.points, soup.polygons);
  std::size_t proper = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    proper += !surface.is_degenerate(f);
  std::vector<std::size_t> labels(soup.polygons.size());
  const auto expect_number = [&](std::size_t k, const auto& method) {
    const auto np = RS::parameters::number_of_segments(k).method(method);
    EXPECT_EQ(RS::segment_polygon_soup(soup.points, soup.polygons, labels, np), k);
    EXPECT_TRUE(is_numbered_by_first_face(labels, k));
    const RS::Polygon_soup_segmenter segmenter(soup.points, soup.polygons, np);
    std::vector<std::size_t> again(labels.size());
    EXPECT_EQ(segmenter.segment(again), k);
    EXPECT_EQ(again, labels);
  };
  for (const std::size_t k : {std::size_t(1), proper / 9, proper / 4, proper / 3, proper / 2,
                              proper / 2 + 1, proper * 3 / 4, proper - 2, proper - 1, proper}) {
    SCOPED_TRACE(std::to_string(k) + " of " + std::to_string(proper));
    expect_number(std::max<std::size_t>(k, 1), RS::Learned_merging());
    expect_number(std::max<std::size_t>(k, 1), RS::Visibility_merging());
  }
}

TEST(Learned_merging_test, there_are_as_many_segments_as_are_asked_for)
{
  expect_every_number(sphere(3));
  expect_every_number(sphere(4));
  for (Family family : all_families)
    for (unsigned seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      expect_every_number(random_mesh(family, seed));
    }
}

TEST(Learned_merging_test, there_are_as_many_segments_as_are_asked_for_where_patches_are_few)
{
  // Columns from 1 to 2^-25 wide: most faces are so small that patches have several.
  Soup soup = mapped(triangulated(grid(30, 12)), [](const Point& p) {
    return Point{std::exp2(-p[0] / 1.2), p[1] / 12, 0};
  });
  const RS::Surface surface = RS::make_surface_of_polygon_soup(soup.points, soup.polygons);
  ASSERT_LT(RS::internal::Patch_builder::build(surface, 0, RS::Execution()).fine.size(),
            surface.number_of_faces() * 3 / 4);
  expect_every_number(soup);
  expect_every_number(joined(soup, translated(scaled(sphere(1), 1e-4), 2, 0, 0))); // a crumb
}

/// Whether each segment has a face that is not degenerate, for all numbers of segments.
template <typename Method>
void expect_proper_segments(const Soup& soup, const Method& method)
{
  const RS::Polygon_soup_segmenter segmenter(soup.points, soup.polygons,
                                             RS::parameters::method(method));
  for (std::size_t k = 2; k <= segmenter.regions().number_of_parts(); ++k) {
    Labels labels(soup.polygons.size());
    const std::size_t n = segmenter.segment(labels, k);
    std::set<std::size_t> proper;
    for (std::size_t f = 0; f < labels.size(); ++f)
      if (!segmenter.surface().is_degenerate(f))
        proper.insert(labels[f]);
    EXPECT_EQ(proper.size(), n) << k;
  }
}

TEST(Learned_merging_test, no_segment_keeps_degenerate_faces_alone_when_borders_move)
{
  for (Family family : {Family::DEGENERATE_SHEET, Family::DEGENERATE_TORUS})
    for (unsigned seed = 1; seed <= 30; ++seed) { // 5, 15 and 28 had such segments
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      expect_proper_segments(random_mesh(family, seed), RS::Learned_merging());
      expect_proper_segments(random_mesh(family, seed), RS::Visibility_merging());
    }
}

TEST(Learned_merging_test, is_the_default_and_needs_no_number)
{
  const Surface_mesh mesh = to_surface_mesh(random_mesh(Family::BLOCKS, 4));
  const Result by_default = run(mesh, RS::parameters::number_of_segments(5));
  const Result by_name = run(mesh,
                             RS::parameters::number_of_segments(5).method(RS::Learned_merging()));
  EXPECT_EQ(by_default.segments, by_name.segments);
  EXPECT_EQ(by_default.regions, by_name.regions);

  const Result chosen = run(mesh, RS::parameters::default_values());
  EXPECT_EQ(chosen.segments,
            labels_of(chosen.regions, chosen.tree.partition_at_count(chosen.number_of_segments)));
}

TEST(Learned_merging_test, does_not_depend_on_the_numbering)
{
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    Soup soup = triangulated(seed % 2 == 0 ? sphere(4) : torus(40, 24));
    if (seed > 4) // other components
      soup = joined(joined(soup, translated(triangulated(torus(30, 20)), 3, 8, 0)),
                    translated(sphere(3), -4, 0, 1));
    for (Point& p : soup.points) // no two faces are alike
      for (double& x : p)
        x *= 1 + 0.05 * any(random);
    Soup other = soup;
    std::vector<std::size_t> order(soup.polygons.size()), new_vertex;
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t i = 0; i < order.size(); ++i) {
      other.polygons[order[i]] = soup.polygons[i];
      std::rotate(other.polygons[order[i]].begin(), other.polygons[order[i]].begin() + random() % 3,
                  other.polygons[order[i]].end());
    }
    shuffle_vertices(other, random, new_vertex);
    const auto expect_same = [&](const Labels& labels, const Labels& of_other) {
      Labels in_order(labels.size());
      for (std::size_t i = 0; i < order.size(); ++i)
        in_order[i] = of_other[order[i]];
      EXPECT_EQ(renumbered(in_order), labels);
    };
    expect_same(segment_into(soup, 7), segment_into(other, 7));
    expect_same(segment_into(soup, 200), segment_into(other, 200));
    expect_same(segment_automatically(soup), segment_automatically(other));
  }
}

TEST(Learned_merging_test, an_isolated_vertex_changes_nothing)
{
  const Soup soup = random_mesh(Family::SPHERE, 1);
  Surface_mesh mesh = to_surface_mesh(soup), same = mesh;
  same.add_vertex(Surface_mesh::Point(1e9, -1e9, 1e9));
  const auto np = RS::parameters::number_of_segments(5);
  EXPECT_EQ(run(same, np).segments, run(mesh, np).segments);
}

TEST(Learned_merging_test, gives_something_sensible_where_there_is_nothing)
{
  EXPECT_EQ(number_of(segment_automatically(sphere(3))), 1u);
  EXPECT_EQ(number_of(segment_automatically(joined(sphere(1), translated(sphere(1), 5, 0, 0)))),
            2u);
  Soup triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.polygons = {{0, 1, 2}};
  EXPECT_EQ(number_of(segment_automatically(triangle)), 1u);
  Soup flat = triangle; // no area at all
  flat.points[2] = {2, 0, 0};
  EXPECT_EQ(number_of(segment_automatically(flat)), 1u);
}

} // namespace Learned_merging_test
