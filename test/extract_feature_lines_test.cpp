// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"
#include "stages.h"

#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>
#include <CGAL/Region_segmentation/Two_step/extract_feature_lines.h>
#include <CGAL/Region_segmentation/Two_step/grow_regions.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace extract_feature_lines_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;
using Line = std::vector<std::size_t>;

struct Lines
{
  std::set<Edge> features; // that remain
  std::vector<Line> lines;
};

template <typename Parameters>
Lines extract(const Soup& soup, const std::set<Edge>& features, const Parameters& np,
              std::size_t minimum_length = std::size_t(-1))
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  auto map = edge_map(mesh, features);
  std::vector<std::vector<Surface_mesh::Vertex_index>> polylines;
  Lines result;
  test::extract_feature_lines(mesh, map, std::back_inserter(polylines), minimum_length, np);
  result.features = marked_edges(mesh, map);
  for (const auto& polyline : polylines)
    result.lines.emplace_back(polyline.begin(), polyline.end());
  return result;
}

Lines extract(const Soup& soup, const std::set<Edge>& features)
{
  // Linked, vertices of coinciding borders are one.
  return extract(soup, features, RS::parameters::component_links(false));
}

std::set<Edge> borders(const Soup& soup)
{
  std::set<Edge> result;
  for (const auto& [edge, faces] : faces_of_edges(soup))
    if (faces.size() == 1)
      result.insert(edge);
  return result;
}

std::set<Edge> both(std::set<Edge> a, const std::set<Edge>& b)
{
  a.insert(b.begin(), b.end());
  return a;
}

// Vertices of the sheet that most tests use:
//     15-16-17-18-19
//      |  |  |  |  |
//     10-11-12-13-14
//      |  |  |  |  |
//      5--6--7--8--9
//      |  |  |  |  |
//      0--1--2--3--4
const Soup sheet = grid(4, 3);

TEST(Extract_feature_lines_test, short_lines_go_at_once)
{
  // Two lines of one edge and one of two from the border meet in 7. Of the short ones neither may
  // save the other, as a part of a line of three edges: both go.
  //          12
  //           |
  //     5--6--7--8
  const std::set<Edge> features = {{5, 6}, {6, 7}, {7, 8}, {7, 12}};
  EXPECT_EQ(extract(sheet, features, RS::parameters::default_values(), 2).features,
            both(borders(sheet), {{5, 6}, {6, 7}}));
}

TEST(Extract_feature_lines_test, lines_cover_the_features_once)
{
  for_each_random_mesh(all_families, 15, [&](const Soup& soup, unsigned seed) {
    std::mt19937 random(seed);
    const auto result = extract(soup, random_edges(soup, 2, random));
    std::vector<Edge> covered;
    std::map<std::size_t, std::size_t> degree;
    for (const Edge& e : result.features)
      ++degree[e.first], ++degree[e.second];
    for (const Line& line : result.lines) {
      ASSERT_GE(line.size(), 2u);
      for (std::size_t i = 1; i < line.size(); ++i)
        covered.push_back(make_edge(line[i - 1], line[i]));
      for (std::size_t i = 1; i + 1 < line.size(); ++i)
        EXPECT_EQ(degree[line[i]], 2u) << "inside a line";
      if (line.front() != line.back()) {
        EXPECT_NE(degree[line.front()], 2u);
        EXPECT_NE(degree[line.back()], 2u);
      }
    }
    std::sort(covered.begin(), covered.end());
    EXPECT_EQ(covered, std::vector<Edge>(result.features.begin(), result.features.end()));
  });
}

/// The regions between the edges of a set.
Labels regions(const Soup& soup, const std::set<Edge>& features, const std::set<Edge>& constrained)
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  auto feature_map = edge_map(mesh, features);
  auto region_map = face_map(mesh);
  test::grow_regions(
    mesh, feature_map, region_map,
    RS::parameters::component_links(false).edge_is_constrained_map(edge_map(mesh, constrained)));
  return labels_of(mesh, region_map);
}

TEST(Extract_feature_lines_test, pruning_leaves_the_regions_alone)
{
  for_each_random_mesh(all_families, 25, [&](const Soup& soup, unsigned seed) {
    std::mt19937 random(seed);
    const Surface_mesh mesh = to_surface_mesh(soup);
    const std::set<Edge> constrained = seed % 2 ? random_edges(soup, 12, random) : std::set<Edge>();
    const std::set<Edge> before = both(
      both(borders(soup), random_edges(soup, 2 + seed % 3, random)), constrained);
    const auto after = extract(
      soup, before,
      RS::parameters::component_links(false).edge_is_constrained_map(edge_map(mesh, constrained)));
    EXPECT_TRUE(
      std::includes(before.begin(), before.end(), after.features.begin(), after.features.end()));
    EXPECT_EQ(regions(soup, before, constrained), regions(soup, after.features, constrained));
  });
}

TEST(Extract_feature_lines_test, an_edge_of_three_faces_is_a_line)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0.5}, {0, 0, 1}};
  const std::vector<Polygon> pages = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
  const RS::Surface surface = RS::make_surface_of_polygon_soup(points, pages);
  auto is_feature = RS::detect_feature_edges(surface, 1, RS::Feature_convexity::ALL);
  std::vector<std::vector<RS::Surface::Index>> lines;
  RS::extract_feature_lines(surface, is_feature, std::back_inserter(lines));
  EXPECT_EQ(lines.size(), 4u) << "the borders of the pages, and their common edge";
}

} // namespace extract_feature_lines_test
