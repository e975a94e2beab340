// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"
#include "shapes_with_faces.h"

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/segment.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace Smooth_faces_test {

using shapes_with_faces::pi;

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

Labels smooth_faces(const Soup& soup)
{
  return segments_of(to_surface_mesh(soup), RS::parameters::method(RS::Smooth_faces()));
}

TEST(Smooth_faces_test, joins_the_facets_of_a_coarse_cylinder)
{
  for (std::size_t sides : {8, 9, 12, 13, 16, 24, 64}) {
    const Labelled cylinder = regular_prism(sides, true);
    EXPECT_EQ(smooth_faces(cylinder.soup), cylinder.truth) << sides;
    EXPECT_EQ(number_of_labels(smooth_faces(triangulated(cylinder.soup))), 3u) << sides;
  }
}

/// Beside each facet there is one that is thirty times as narrow.
TEST(Smooth_faces_test, joins_facets_and_slivers_between_them)
{
  const std::size_t sides = 20;
  Profile profile;
  for (std::size_t i = 0; i < sides; ++i)
    for (const double t : {0.0, i % 3 == 0 ? 0.03 : 0.97}) {
      const double angle = 2 * pi * (double(i) + t) / double(sides);
      profile.points.push_back({std::cos(angle), std::sin(angle)});
      profile.faces.push_back(0);
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
  EXPECT_TRUE(nests(found, cylinder.truth) && nests(cylinder.truth, found));
}

/// A third triangle on an edge of a cube: it is a component of its own, so small that it is a
/// crumb, and belongs to one of the planes, which join nothing else.
TEST(Smooth_faces_test, slivers_on_edges_join_no_planes)
{
  Soup soup;
  soup.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},       {0, 0, 4},
                 {4, 0, 4}, {4, 4, 4}, {0, 4, 4}, {4, 0, 4.000001}};
  soup.polygons = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5},
                   {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 8}};
  Labels labels(soup.polygons.size());
  EXPECT_EQ(RS::segment_polygon_soup(soup.points, soup.polygons, labels,
                                     RS::parameters::method(RS::Smooth_faces())),
            6u);
  labels.pop_back();
  EXPECT_EQ(number_of_labels(labels), 6u);
}

TEST(Smooth_faces_test, separates_the_sides_of_a_prism)
{
  for (std::size_t sides : {3, 4, 6, 7}) {
    const Labelled prism = regular_prism(sides, false);
    EXPECT_EQ(smooth_faces(prism.soup), prism.truth) << sides;
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

/// Whether labels of some faces of the soup are all different.
bool are_separate(const Labels& labels, const Labels& truth, const std::vector<std::size_t>& faces)
{
  std::set<std::size_t> found;
  for (std::size_t face : faces)
    found.insert(labels[std::size_t(std::find(truth.begin(), truth.end(), face) - truth.begin())]);
  return found.size() == faces.size();
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
    EXPECT_TRUE(nests(finer, labels)) << k;
    // Fillets, which are faces 2, 4, 6 and 8, join the planes beside them first.
    EXPECT_TRUE(k < 6 || are_separate(labels, block.truth, {0, 1, 3, 5, 7, 9})) << k;
    finer = labels;
  }
  EXPECT_EQ(segmenter.segment(map, 13), 10u); // no more than there are
}

Labelled part(const shapes_with_faces::Shape& shape)
{
  return {soup_of(shape), Labels(shape.faces.begin(), shape.faces.end())};
}

std::vector<std::pair<const char*, shapes_with_faces::Shape>> parts()
{
  using namespace shapes_with_faces;
  return {{"box", box(1, 2, 3, 3)},
          {"ring", ring(2, 2, 1, 3, 24, 2)},
          {"coarse ring", ring(2, 2, 1, 3, 12, 1)},
          {"cone", ring(3, 2, 1, 2, 24, 3)},
          {"filleted bar", filleted_bar(3, 1, 5, 6, 5)},
          {"coarse filleted bar", filleted_bar(3, 1, 5, 3, 1)},
          {"bar rounded widely", filleted_bar(1, 20, 5, 30, 8)},
          {"dome", dome(2, 24, 7)},
          {"torus", torus(3, 1, 40, 16)}};
}

TEST(Smooth_faces_test, holes_join_what_they_are_in_before_others)
{
  // Outside, hole, top, bottom.
  const Labelled ring = part(shapes_with_faces::ring(2, 2, 1, 3, 24, 2));
  const Labels labels = segments_of(
    to_surface_mesh(ring.soup), RS::parameters::number_of_segments(3).method(RS::Smooth_faces()));
  EXPECT_TRUE(are_separate(labels, ring.truth, {0, 2, 3}));
}

/// 2 true faces that are found / (true faces + segments), by intersection over union of .9 of the
/// number of triangles.
double f1(const Labels& truth, const Labels& found)
{
  std::map<std::pair<std::size_t, std::size_t>, double> common;
  std::map<std::size_t, double> of_truth, of_found;
  for (std::size_t f = 0; f < truth.size(); ++f) {
    ++common[{truth[f], found[f]}];
    ++of_truth[truth[f]];
    ++of_found[found[f]];
  }
  double number = 0;
  for (const auto& [pair, n] : common)
    number += n >= .9 * (of_truth[pair.first] + of_found[pair.second] - n);
  return 2 * number / double(of_truth.size() + of_found.size());
}

Labels labels_of_soup(const Soup& soup, const RS::Smooth_faces& method = RS::Smooth_faces())
{
  Labels labels(soup.polygons.size());
  RS::segment_polygon_soup(soup.points, soup.polygons, labels, RS::parameters::method(method));
  return labels;
}

TEST(Smooth_faces_test, finds_the_faces_of_parts)
{
  const unsigned seed = 5;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const auto& [name, shape] : parts()) {
    SCOPED_TRACE(name);
    const auto [soup, truth] = part(shape);
    const std::vector<std::pair<const char*, Soup>> variants = {
      {"as it is", soup},
      {"inside out", reversed(soup)},
      {"moved", translated(soup, 30, -20, 10)},
      {"small", scaled(soup, 1e-6)},
      {"large", scaled(soup, 1e6)},
      {"triangles by themselves", torn(soup)}};
    for (const auto& [change, variant] : variants)
      EXPECT_EQ(f1(truth, labels_of_soup(variant)), 1) << change;
    std::vector<std::size_t> order(truth.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::shuffle(order.begin(), order.end(), random);
    Soup shuffled{soup.points, {}};
    Labels shuffled_truth;
    for (std::size_t f : order) {
      shuffled.polygons.push_back(soup.polygons[f]);
      shuffled_truth.push_back(truth[f]);
    }
    EXPECT_EQ(f1(shuffled_truth, labels_of_soup(shuffled)), 1) << "in random order";
  }
}

TEST(Smooth_faces_test, a_given_tolerance_is_in_units_of_the_mesh)
{
  std::mt19937 random(6);
  Labelled bar = part(shapes_with_faces::filleted_bar(3, 1, 5, 12, 20));
  bump(bar.soup, 2e-3, random);
  RS::Smooth_faces method;
  for (double scale : {1.0, 1000.0}) {
    method.tolerance = 1e-2 * scale;
    // Which of the two smooth neighbors a triangle is on is within the noise.
    EXPECT_EQ(number_of_labels(labels_of_soup(scaled(bar.soup, scale), method)), 10u) << scale;
    method.tolerance = 1e-7 * scale;
    EXPECT_LE(f1(bar.truth, labels_of_soup(scaled(bar.soup, scale), method)), 0.5) << scale;
  }
}

/// Cancels when the stage has come so far.
struct Canceller
{
  double fraction;
  std::set<double> seen;

  bool on_progress(const char* stage, double f)
  {
    if (stage != std::string("regions"))
      return true;
    seen.insert(f);
    return f < fraction;
  }
};

TEST(Smooth_faces_test, reports_progress_and_is_cancelled)
{
  const Surface_mesh mesh = to_surface_mesh(soup_of(shapes_with_faces::torus(3, 1, 40, 16)));
  auto map = face_map(mesh);
  Canceller all{2, {}}, half{0.5, {}};
  RS::segment(mesh, map, RS::parameters::method(RS::Smooth_faces()).visitor(std::ref(all)));
  EXPECT_GE(all.seen.size(), 20u);
  EXPECT_EQ(*all.seen.begin(), 0);
  EXPECT_EQ(*all.seen.rbegin(), 1);
  EXPECT_THROW(
    RS::segment(mesh, map, RS::parameters::method(RS::Smooth_faces()).visitor(std::ref(half))),
    RS::Segmentation_cancelled);
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
  const Labels labels = segments_of(
    mesh, RS::parameters::method(RS::Smooth_faces()).edge_is_constrained_map(drawn));
  EXPECT_EQ(number_of_labels(labels), 4u);
}

TEST(Surface_face_cost_test, is_as_documented)
{
  using Data = RS::Surface_face_region_data;
  using RS::Face_role;
  constexpr auto several = Data::several;
  const auto cost = [](const Data& a, const Data& b, double length, double smooth_length) {
    RS::Region_adjacency_graph<Data, RS::Surface_face_section_data> graph;
    graph.add_region(a);
    graph.add_region(b);
    RS::Surface_face_section_data data;
    data.length = length;
    data.smooth_length = smooth_length;
    return RS::Surface_face_cost()(graph, graph.add_section(0, 1, data));
  };
  const double size = std::sqrt(0.04) * (1 - 0.5 / 2) / 2;
  const Data large{0.5, 1, Face_role::NONE}, small{0.04, 2, Face_role::NONE},
    blend{0.04, 2, Face_role::BLEND}, hole{0.04, 3, Face_role::HOLE},
    mixed{0.04, several, Face_role::NONE};
  EXPECT_DOUBLE_EQ(cost(large, {0.04, 1, Face_role::NONE}, 1, 0), size);
  EXPECT_DOUBLE_EQ(cost(large, blend, 1, 0.6), 1 + size);
  EXPECT_DOUBLE_EQ(cost(blend, large, 1, 0.6), 1 + size);
  EXPECT_DOUBLE_EQ(cost(large, blend, 1, 0.4), 2 + size);
  EXPECT_DOUBLE_EQ(cost(large, hole, 1, 0.6), 2 + size);
  EXPECT_DOUBLE_EQ(cost(hole, blend, 1, 0.6), 1 + 0.2 * (1 - 0.04 / 2) / 2);
  EXPECT_DOUBLE_EQ(cost({0.5, 1, Face_role::BLEND}, blend, 1, 1), 2 + size);
  EXPECT_DOUBLE_EQ(cost(large, small, 1, 1), 3 + size);
  EXPECT_DOUBLE_EQ(cost({0.5, several, Face_role::NONE}, mixed, 1, 0), 3 + size);
  EXPECT_DOUBLE_EQ(cost(large, blend, 0, 0), 4 + size);
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
