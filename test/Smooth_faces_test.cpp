// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"
#include "reference_smoothness.h"

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Methods/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/internal/regions/Face_links.h>
#include <CGAL/Region_segmentation/internal/regions/Normal_section.h>
#include <CGAL/Region_segmentation/make_surface.h>
#include <CGAL/Region_segmentation/segment.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace Smooth_faces_test {

constexpr double pi = 3.14159265358979323846;

struct Labelled
{
  Soup soup;
  Labels truth;
};

/// Points of a plane, and the face that starts at each of them.
struct Profile
{
  std::vector<std::array<double, 2>> points;
  Labels faces;

  /// From one angle to the other, both included, in degrees; its last point starts another face.
  void add_arc(double x, double y, double radius, double from, double to, int steps,
               std::size_t face, std::size_t next_face)
  {
    for (int i = 0; i <= steps; ++i) {
      const double angle = (from + (to - from) * i / steps) * pi / 180;
      points.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
      faces.push_back(i < steps ? face : next_face);
    }
  }
};

/// A prism of quads between two polygons, which are the first two faces.
Labelled prism(const Profile& profile, double height)
{
  Labelled result;
  const std::size_t n = profile.points.size();
  for (double z : {0.0, height})
    for (const auto& p : profile.points)
      result.soup.points.push_back({p[0], p[1], z});
  Polygon below, above;
  for (std::size_t i = 0; i < n; ++i) {
    below.push_back(n - 1 - i);
    above.push_back(n + i);
  }
  result.soup.polygons = {below, above};
  for (std::size_t i = 0; i < n; ++i)
    result.soup.polygons.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  result.truth = {0, 1};
  for (std::size_t face : profile.faces)
    result.truth.push_back(2 + face);
  return result;
}

Labelled regular_prism(std::size_t sides, bool is_round)
{
  Profile profile;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 2 * pi * double(i) / double(sides);
    profile.points.push_back({std::cos(angle), std::sin(angle)});
    profile.faces.push_back(is_round ? 0 : i);
  }
  return prism(profile, 1.7);
}

/// A block whose vertical edges are rounded, by `steps` facets each.
Labelled filleted_block(int steps)
{
  Profile profile;
  profile.add_arc(2, 1, 0.3, 0, 90, steps, 0, 1);
  profile.add_arc(-2, 1, 0.3, 90, 180, steps, 2, 3);
  profile.add_arc(-2, -1, 0.3, 180, 270, steps, 4, 5);
  profile.add_arc(2, -1, 0.3, 270, 360, steps, 6, 7);
  return prism(profile, 1.5);
}

std::size_t number_of_labels(const Labels& labels)
{
  return std::set<std::size_t>(labels.begin(), labels.end()).size();
}

/// Whether faces with equal labels in `finer` have equal ones in `coarser`.
bool is_refinement(const Labels& finer, const Labels& coarser)
{
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t f = 0; f < finer.size(); ++f)
    pairs.insert({finer[f], coarser[f]});
  return pairs.size() == number_of_labels(finer);
}

Labels smooth_faces(const Soup& soup)
{
  return segments_of(to_surface_mesh(soup), RS::parameters::method(RS::Smooth_faces()));
}

TEST(Smooth_faces_test, joins_the_facets_of_a_coarse_cylinder)
{
  for (std::size_t sides : {12, 13, 16, 24, 64}) {
    const Labelled cylinder = regular_prism(sides, true);
    EXPECT_EQ(smooth_faces(cylinder.soup), cylinder.truth) << sides;
    EXPECT_EQ(number_of_labels(smooth_faces(triangulated(cylinder.soup))), 3u) << sides;
  }
}

TEST(Smooth_faces_test, starts_from_facets_that_are_flat_but_for_rounding)
{
  Surface_mesh mesh = to_surface_mesh(regular_prism(720, true).soup); // half a degree apart
  auto region = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:region").first;
  auto segment = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:segment").first;
  EXPECT_EQ(
    RS::segment(mesh, segment, RS::parameters::method(RS::Smooth_faces()).region_map(region)), 3u);
  std::set<std::size_t> regions;
  for (auto f : mesh.faces())
    regions.insert(region[f]);
  EXPECT_EQ(regions.size(), 722u);
}

/// As Boolean operations leave them: no face is as wide as its facet.
TEST(Smooth_faces_test, joins_facets_that_are_divided_into_slivers)
{
  const std::size_t sides = 20;
  Profile profile;
  for (std::size_t i = 0; i < sides; ++i) {
    const auto corner = [&](std::size_t j) {
      return std::array<double, 2>{std::cos(2 * pi * double(j) / sides),
                                   std::sin(2 * pi * double(j) / sides)};
    };
    const auto a = corner(i), b = corner(i + 1);
    profile.points.push_back(a);
    const double t = i % 3 == 0 ? 0.03 : 0.97;
    profile.points.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
    profile.faces.insert(profile.faces.end(), 2, 0);
  }
  const Labelled cylinder = prism(profile, 1.7);
  EXPECT_EQ(smooth_faces(cylinder.soup), cylinder.truth);
  EXPECT_EQ(number_of_labels(smooth_faces(triangulated(cylinder.soup))), 3u);
}

/// A corner that is there twice: two triangles without area reach from one cap to the other. Where
/// they come first, they are a region of their own.
TEST(Smooth_faces_test, faces_without_area_are_no_bridges)
{
  Labelled cylinder = regular_prism(16, true);
  Soup& soup = cylinder.soup;
  const std::size_t below = 5, above = 16 + 5, n = soup.points.size();
  soup.points.push_back(soup.points[below]);
  soup.points.push_back(soup.points[above]);
  // The face after the corner takes the copies, and so do the caps between both.
  std::replace(soup.polygons[2 + 5].begin(), soup.polygons[2 + 5].end(), below, n);
  std::replace(soup.polygons[2 + 5].begin(), soup.polygons[2 + 5].end(), above, n + 1);
  Polygon &cap_below = soup.polygons[0], &cap_above = soup.polygons[1];
  cap_below.insert(std::find(cap_below.begin(), cap_below.end(), below), n);
  cap_above.insert(std::find(cap_above.begin(), cap_above.end(), above) + 1, n + 1);
  soup.polygons.insert(soup.polygons.begin(), {{below, n, n + 1}, {below, n + 1, above}});
  ASSERT_TRUE(is_manifold(soup));
  Labels found = smooth_faces(soup);
  EXPECT_EQ(number_of_labels(found), 3u);
  found.erase(found.begin(), found.begin() + 2);
  EXPECT_TRUE(is_refinement(found, cylinder.truth) && is_refinement(cylinder.truth, found));
}

TEST(Smooth_faces_test, separates_the_sides_of_a_prism)
{
  for (std::size_t sides : {3, 4, 6, 8, 10}) {
    const Labelled prism = regular_prism(sides, false);
    EXPECT_EQ(smooth_faces(prism.soup), prism.truth) << sides;
  }
}

TEST(Smooth_faces_test, separates_fillets_from_planes)
{
  for (int steps : {3, 4, 6, 9, 18}) {
    const Labelled block = filleted_block(steps);
    EXPECT_EQ(smooth_faces(block.soup), block.truth) << steps;
    EXPECT_EQ(smooth_faces(scaled(block.soup, 1000)), block.truth) << steps;
    EXPECT_EQ(smooth_faces(translated(block.soup, 30, -20, 10)), block.truth) << steps;
  }
}

/// A crease of less than the angle between facets of other cylinders.
TEST(Smooth_faces_test, separates_planes_at_a_shallow_crease)
{
  for (double angle : {12.0, 20.0, 30.0}) {
    Profile profile;
    const double c = std::cos(angle * pi / 180), s = std::sin(angle * pi / 180);
    profile.points = {{0, 0}, {2, 0}, {2 + 2 * c, 2 * s}, {2, 6}, {0, 6}};
    profile.faces = {0, 1, 2, 3, 4};
    const Labelled part = prism(profile, 3);
    EXPECT_EQ(smooth_faces(part.soup), part.truth) << angle;
  }
}

TEST(Smooth_faces_test, a_smooth_surface_is_one_face)
{
  for (const Soup& soup : {sphere(3), sphere(4), torus(40, 20)})
    EXPECT_EQ(smooth_faces(soup), Labels(soup.polygons.size(), 0));
}

TEST(Smooth_faces_test, separates_the_faces_of_blocks)
{
  EXPECT_EQ(number_of_labels(smooth_faces(cube())), 6u);
  EXPECT_EQ(number_of_labels(smooth_faces(l_shape())), 8u);
}

TEST(Smooth_faces_test, merges_on_when_a_number_is_given)
{
  const Labelled block = filleted_block(6);
  const Surface_mesh mesh = to_surface_mesh(block.soup);
  const RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Smooth_faces()));
  auto map = face_map(mesh);
  Labels finer = block.truth;
  for (std::size_t k : {10, 9, 6, 3, 2, 1}) {
    EXPECT_EQ(segmenter.segment(map, k), k);
    const Labels labels = labels_of(mesh, map);
    EXPECT_TRUE(is_refinement(finer, labels)) << k;
    finer = labels;
  }
  // More than there are: the facets of fillets are separated.
  EXPECT_EQ(segmenter.segment(map, 13), 13u);
  EXPECT_TRUE(is_refinement(labels_of(mesh, map), block.truth));
}

TEST(Smooth_faces_test, keeps_constrained_edges)
{
  const Labelled cylinder = regular_prism(16, true);
  Surface_mesh mesh = to_surface_mesh(cylinder.soup);
  auto drawn = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:drawn", false).first;
  std::size_t number = 0;
  for (auto e : mesh.edges()) { // two opposite edges of the side
    const auto p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    if (p.z() != q.z() && std::abs(p.y()) < 1e-9) {
      drawn[e] = true;
      ++number;
    }
  }
  ASSERT_EQ(number, 2u);
  const Labels labels =
    segments_of(mesh, RS::parameters::method(RS::Smooth_faces()).edge_is_constrained_map(drawn));
  EXPECT_EQ(number_of_labels(labels), 4u);
}

TEST(Smooth_faces_test, accepts_borders_and_degenerate_faces)
{
  EXPECT_EQ(number_of_labels(smooth_faces(grid(3, 4))), 1u);
  for (Family family : all_families) {
    const Soup soup = random_mesh(family, 7);
    EXPECT_EQ(smooth_faces(soup).size(), soup.polygons.size());
  }
}

using Graph = RS::Region_adjacency_graph<RS::Smoothness_region_data, RS::Smoothness_section_data>;

Graph annotated(const RS::Surface& surface, const Labels& labels)
{
  const RS::Partition regions = RS::Partition::from_labels(labels);
  auto graph =
    RS::build_region_adjacency_graph<RS::Smoothness_region_data, RS::Smoothness_section_data>(
      surface, regions);
  const RS::Smoothness_annotator annotator;
  annotator(graph, surface, regions, annotator.discontinuities(surface));
  return graph;
}

/// The discontinuities of the sections between the regions of a mesh.
std::vector<double> discontinuities(const Labelled& part)
{
  const RS::Surface surface = RS::make_surface(to_surface_mesh(part.soup));
  const Graph graph = annotated(surface, part.truth);
  std::vector<double> result;
  for (auto range = edges(graph); range.first != range.second; ++range.first)
    result.push_back(graph[*range.first].mean_discontinuity());
  return result;
}

/// Each facet for itself. Facets of a cylinder are smooth; caps meet them at 90 degrees of 32,
/// which count 3.
TEST(Smoothness_annotator_test, measures_a_cylinder)
{
  Labelled cylinder = regular_prism(24, false);
  for (double discontinuity : discontinuities(cylinder))
    EXPECT_TRUE(std::abs(discontinuity) < 1e-9 || std::abs(discontinuity - 3 * 90 / 32.0) < 1e-9)
      << discontinuity;
}

/// At the border of a fillet of four facets the curvature falls from 1 / r to 0.
TEST(Smoothness_annotator_test, measures_a_fillet)
{
  std::size_t at_borders = 0;
  for (double discontinuity : discontinuities(filleted_block(4))) {
    at_borders += std::abs(discontinuity - 1) < 0.02;
    EXPECT_TRUE(std::abs(discontinuity - 1) < 0.02 || discontinuity > 3) << discontinuity;
  }
  EXPECT_EQ(at_borders, 8u);
}

TEST(Smoothness_annotator_test, measures_as_documented)
{
  std::mt19937 random(1);
  std::vector<Soup> soups = {sphere(2), torus(40, 20), regular_prism(20, true).soup,
                             filleted_block(5).soup, grid(12, 12)};
  for (Point& p : soups.back().points)
    p[2] = std::sin(p[0] / 2) + 0.1 * p[1] * (p[1] > 6); // waves, and a shallow crease
  std::size_t creases = 0, smooth = 0, between = 0;
  for (Soup& soup : soups)
    for (double amplitude : {1e-4, 0.01, 0.05}) {
      SCOPED_TRACE(std::to_string(soup.polygons.size()) + " polygons, amplitude " +
                   std::to_string(amplitude));
      Soup bumpy = triangulated(soup);
      bump(bumpy, amplitude, random);
      const RS::Surface surface = RS::make_surface(to_surface_mesh(bumpy));
      Labels each(bumpy.polygons.size());
      std::iota(each.begin(), each.end(), std::size_t(0));
      const Graph graph = annotated(surface, each);
      const reference::Smoothness expected(bumpy);
      for (auto range = edges(graph); range.first != range.second; ++range.first) {
        const double d = graph[*range.first].mean_discontinuity();
        const std::size_t a = graph.source(*range.first), b = graph.target(*range.first);
        EXPECT_NEAR(d, expected.discontinuity(a, b), 1e-6) << a << ' ' << b;
        ++(d >= 3 ? creases : d < 0.5 ? smooth : between);
      }
    }
  EXPECT_GT(creases, 100u);
  EXPECT_GT(smooth, 100u);
  EXPECT_GT(between, 100u);
}

TEST(Normal_section_test, a_path_ends_after_the_most_crossings)
{
  // Along a strip of unit squares, from its end.
  constexpr int most = RS::internal::Normal_path::most_crossings;
  const RS::Surface surface = RS::make_surface(to_surface_mesh(grid(most + 10, 1)));
  const RS::internal::Face_links links(surface);
  const RS::internal::Face_edge end{0, 3};
  EXPECT_EQ(RS::internal::Normal_section(surface, links, end, 2 * most, 0.1, 0.5).length, most);
  EXPECT_EQ(RS::internal::Normal_section(surface, links, end, most - 0.5, 0.1, 0.5).length,
            most - 0.5);
  EXPECT_EQ(RS::internal::facet_height(surface, links, end, 0.1), most);
}

TEST(Smoothness_data_test, degenerate_faces_have_no_area)
{
  Soup soup = grid(2, 1);
  soup.points[2] =
    soup.points[1]; // the second face has only two corners that differ from each other
  soup.points[5] = soup.points[4];
  const RS::Surface surface = RS::make_surface(to_surface_mesh(soup));
  const Graph graph = annotated(surface, {0, 1});
  EXPECT_EQ(graph[0].area, 1);
  EXPECT_EQ(graph[1].area, 0);
}

TEST(Smoothness_data_test, counts_the_edges_of_a_section)
{
  const auto sections = [](const Soup& soup, const Labels& labels) {
    return annotated(RS::make_surface(to_surface_mesh(soup)), labels);
  };
  const auto rows = sections(scaled(grid(3, 2), 2), {0, 0, 0, 1, 1, 1});
  EXPECT_EQ(rows[*rows.section(0, 1)].number_of_edges, 3u);
  EXPECT_EQ(rows[*rows.section(0, 1)].length, 6);
  // One edge to each of two regions, which are merged.
  auto three = sections(grid(2, 2), {0, 1, 2, 2});
  three.merge(*three.section(0, 1));
  ASSERT_EQ(three.number_of_sections(), 1u);
  EXPECT_EQ(three[*edges(three).first].number_of_edges, 2u);
  EXPECT_EQ(three[*edges(three).first].length, 2);
}

TEST(Smoothness_cost_test, is_as_documented)
{
  const auto cost = [](double area, double facets, double other_area, double other_facets,
                       double measured, double mean) {
    Graph graph;
    graph.add_region({area, facets});
    graph.add_region({other_area, other_facets});
    RS::Smoothness_section_data data;
    data.length = 7;
    data.measured_length = measured;
    data.discontinuity = measured * mean;
    const auto section = graph.add_section(0, 1, data);
    return RS::Smoothness_cost()(graph, section);
  };
  // Facets of areas 1 and 2 are similar: weighted by the smaller number of facets, of 3 and 4 more.
  EXPECT_DOUBLE_EQ(cost(3, 3, 10, 5, 2, 0.7), 0.7 * 3 / 7);
  EXPECT_DOUBLE_EQ(cost(10, 5, 3, 3, 2, 0.7), 0.7 * 3 / 7);
  // A crease is not, and neither are facets whose areas have the ratio 3 or more.
  EXPECT_DOUBLE_EQ(cost(3, 3, 10, 5, 2, 2), 2);
  EXPECT_DOUBLE_EQ(cost(3, 3, 15, 5, 2, 0.7), 0.7);
  EXPECT_DOUBLE_EQ(cost(15, 5, 3, 3, 2, 0.7), 0.7);
  // Nothing measured: nothing, or the longest section first where a region has no area.
  EXPECT_EQ(cost(1e-3, 1, 1e-3, 1, 0, 0), 0);
  EXPECT_EQ(cost(0, 1, 1, 1, 0, 0), -7);
  EXPECT_EQ(cost(1, 1, 0, 1, 0, 0), -7);
}

TEST(Number_below_cost_test, ends_before_the_first_merge_above_the_bound)
{
  RS::Merge_tree tree(5);
  tree.push_back({2, 3, 1});
  tree.push_back({1, 4, 5});
  tree.push_back({0, 2, 3});
  const auto number = [&tree](double bound) {
    return RS::Number_below_cost{bound}(tree, RS::Surface());
  };
  EXPECT_EQ(number(0.5), 5u);
  EXPECT_EQ(number(1), 4u);
  EXPECT_EQ(number(4), 4u);
  EXPECT_EQ(number(5), 2u);
  EXPECT_EQ(RS::Number_below_cost{1}(RS::Merge_tree(), RS::Surface()), 0u);
}

} // namespace Smooth_faces_test
