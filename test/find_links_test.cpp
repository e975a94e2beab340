// SPDX-License-Identifier: GPL-3.0-or-later

// Components that share no edge: how they are linked where they touch or are near, and which of
// them lie in others.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace find_links_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;

/// Sets of numbers that are united.
struct Disjoint_sets
{
  explicit Disjoint_sets(std::size_t size)
    : parent(size)
    , number(size)
  {
    std::iota(parent.begin(), parent.end(), std::size_t(0));
  }

  std::size_t find(std::size_t i)
  {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  }

  /// Returns false within one set.
  bool unite(std::size_t i, std::size_t j)
  {
    i = find(i);
    j = find(j);
    parent[i] = j;
    number -= i != j;
    return i != j;
  }

  std::vector<std::size_t> parent;
  std::size_t number; // of sets
};

struct Link
{
  std::size_t lower, higher; // faces
  double length;
};

/// The surface of polygons, its links, and its sets of faces that are connected without them.
struct Model
{
  explicit Model(const Soup& soup)
    : surface(RS::make_surface_of_polygon_soup(soup.points, soup.polygons))
    , component_of(surface.number_of_faces())
  {
    Disjoint_sets sets(surface.number_of_faces());
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
      if (surface.has_flag(a, RS::Surface::LINK))
        links.push_back({surface.lower_face(a), surface.higher_face(a), surface.length(a)});
      else
        sets.unite(surface.lower_face(a), surface.higher_face(a));
    for (std::size_t f = 0; f < component_of.size(); ++f)
      component_of[f] = sets.find(f);
    component_of = renumbered(component_of);
    number_of_components = sets.number;
  }

  RS::Surface surface;
  Labels component_of;
  std::size_t number_of_components;
  std::vector<Link> links; // sorted by the higher face, then by the lower one
};

/// What holds for all links: different components, and everything connected. Returns the length of
/// contact.
double checked_length(const Model& m)
{
  Disjoint_sets components(m.number_of_components);
  double sum = 0;
  for (std::size_t i = 0; i < m.links.size(); ++i) {
    const auto [lower, higher, length] = m.links[i];
    EXPECT_NE(m.component_of[lower], m.component_of[higher]);
    EXPECT_TRUE(std::isfinite(length) && length >= 0);
    EXPECT_TRUE(i == 0 ||
                std::tie(m.links[i - 1].higher, m.links[i - 1].lower) <= std::tie(higher, lower));
    components.unite(m.component_of[lower], m.component_of[higher]);
    sum += length;
  }
  EXPECT_EQ(components.number, m.number_of_components > 0 ? 1u : 0u);
  return sum;
}

double checked_length(const Soup& soup)
{
  return checked_length(Model(soup));
}

Soup square(std::size_t n)
{
  return scaled(triangulated(grid(n, n)), 1 / double(n));
}

TEST(find_links_test, one_component_or_none_has_no_links)
{
  EXPECT_TRUE(Model(cube()).links.empty());
  EXPECT_TRUE(Model(Soup()).links.empty());
}

/// The length of contact is about what is expected, however fine the faces are.
void expect_length(const Soup& soup, double expected)
{
  const double length = checked_length(soup);
  EXPECT_GT(length, expected / 3);
  EXPECT_LT(length, expected * 3.5);
}

TEST(find_links_test, crossing_boxes_have_about_the_length_of_the_intersection)
{
  const auto bar = [](const Point& p) {
    return Point{0.31 + 0.2 * p[0], 0.27 + 0.3 * p[1], -1 + 3.01 * p[2]};
  };
  for (const std::size_t n : {1, 2, 7, 30})
    for (const std::size_t m : {1, 2, 7, 30}) {
      SCOPED_TRACE(std::to_string(n) + ' ' + std::to_string(m));
      expect_length(joined(box_of_sheets(n), mapped(box_of_sheets(m), bar)),
                    2 * (2 * 0.2 + 2 * 0.3));
    }
}

TEST(find_links_test, a_box_on_another_has_about_the_border_of_the_contact_area)
{
  for (double gap : {0.0, 0.001, -0.001})
    for (std::size_t n : {1, 5, 20})
      for (std::size_t m : {1, 8, 40}) {
        SCOPED_TRACE(std::to_string(gap) + ' ' + std::to_string(n) + ' ' + std::to_string(m));
        const Soup box = box_of_sheets(m), other = box_of_sheets(n),
                   leg = translated(scaled(other, 0.3), 0.33, 0.41, 1 + gap);
        expect_length(joined(box, leg), 4 * 0.3);
        expect_length(joined(leg, box), 4 * 0.3);
        // side by side, of the same size
        expect_length(joined(other, translated(box, 0, 0, 1 + gap)), 4);
      }
}

TEST(find_links_test, a_contact_of_faces_smaller_than_the_tolerance_has_about_its_border)
{
  expect_length(joined(box_of_sheets(100), translated(box_of_sheets(100), 0.052, 0.013, 1)),
                2 * (0.948 + 0.987));
}

TEST(find_links_test, components_that_nearly_coincide_are_linked_at_all_faces)
{
  for (const Soup& soup : {triangulated(block(3, 3, 3)), sphere(2)})
    EXPECT_GE(Model(joined(soup, scaled(soup, 1.0005))).links.size(), soup.polygons.size());
}

TEST(find_links_test, sheets_touch_along_their_border)
{
  const auto wall = [](const Point& p) { return Point{0.3 + 0.5 * p[0], 0.37, p[1]}; };
  const auto turned = [](const Point& p) {
    return Point{0.3 + 0.5 * p[0], 0.3 + 0.2 * p[0], p[1]};
  };
  for (std::size_t n : {6, 50})
    for (std::size_t m : {10, 40})
      for (double gap : {0.0, 0.0004, -0.0004}) {
        SCOPED_TRACE(std::to_string(n) + ' ' + std::to_string(m) + ' ' + std::to_string(gap));
        const Soup floor = square(m);
        expect_length(joined(floor, translated(mapped(square(n), wall), 0, 0, gap)), 0.5);
        expect_length(joined(floor, translated(mapped(square(n), turned), 0, 0, gap)),
                      std::hypot(0.5, 0.2));
        // in one plane, edge to edge, with other vertices
        expect_length(joined(floor, translated(square(n), 1 + gap, 0, 0)), 1);
      }
}

TEST(find_links_test, a_crumb_joins_the_nearest_component)
{
  const Soup crumb = scaled(sphere(1), 0.01);
  const Model m(joined({scaled(square(1), 100), translated(triangulated(cube()), 40, 40, 3),
                        translated(crumb, 60, 30, 0.5), translated(crumb, 40.5, 40.5, 3.5)}));
  EXPECT_EQ(checked_length(m), 0);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const Link& l : m.links)
    pairs.emplace_back(m.component_of[l.lower], m.component_of[l.higher]);
  EXPECT_EQ(pairs, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {0, 2}, {1, 3}}));
}

/// Of two faces, by another implementation.
double squared_distance(const RS::Surface& surface, std::size_t f, std::size_t g)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  const auto triangle = [&](std::size_t face) {
    const auto corner = [&](std::size_t i) {
      const RS::Double_3& p = surface.point(surface.corner(face, i));
      return Kernel::Point_3(p.x, p.y, p.z);
    };
    return Kernel::Triangle_3(corner(0), corner(1), corner(2));
  };
  return CGAL::squared_distance(triangle(f), triangle(g));
}

/// The gaps that a minimum spanning tree of the components has beside the contacts, by the distance
/// of the nearest faces, have the same number and length together as the links of length 0. (They
/// need not have the same faces: several share a nearest point.)
void compare_with_all_distances(const Model& m)
{
  checked_length(m);
  using Gaps = std::vector<std::tuple<double, std::size_t, std::size_t>>;
  Gaps linked, all;
  for (const Link& l : m.links)
    if (l.length == 0)
      linked.emplace_back(squared_distance(m.surface, l.lower, l.higher), l.lower, l.higher);
  for (std::size_t f = 0; f < m.component_of.size(); ++f)
    for (std::size_t g = 0; g < f; ++g)
      if (m.component_of[f] != m.component_of[g])
        all.emplace_back(squared_distance(m.surface, f, g), g, f);
  const auto lengths_of_tree = [&](Gaps gaps) {
    Disjoint_sets components(m.number_of_components);
    for (const Link& l : m.links)
      if (l.length > 0)
        components.unite(m.component_of[l.lower], m.component_of[l.higher]);
    std::sort(gaps.begin(), gaps.end());
    std::vector<double> lengths;
    for (const auto& [d, g, f] : gaps)
      if (components.unite(m.component_of[f], m.component_of[g]))
        lengths.push_back(std::sqrt(d));
    return lengths;
  };
  const std::vector<double> found = lengths_of_tree(linked), expected = lengths_of_tree(all);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-6) << i;
}

TEST(find_links_test, nested_spheres_are_linked_as_by_all_distances)
{
  std::vector<Soup> spheres;
  for (int i = 0; i < 8; ++i)
    spheres.push_back(
      translated(scaled(sphere(2), 1 + 0.1 * i + 0.01 * i * i), 0.003 * i, 0.001 * i, 0));
  const Model m(joined(spheres));
  EXPECT_EQ(m.links.size(), 7u);
  compare_with_all_distances(m);
}

TEST(find_links_test, random_crumbs_are_linked_as_by_all_distances)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Soup& large : {sphere(2), scaled(square(1), 3)}) {
    std::vector<Soup> scene = {large};
    for (int i = 0; i < 150; ++i) {
      const double size = std::pow(10, -1 - 3 * unit(random));
      Soup crumb = i % 5 == 0 ? triangulated(cube()) : square(1 + std::size_t(i) % 2);
      bump(crumb, 0.1, random);
      scene.push_back(translated(scaled(crumb, size), 2.5 * unit(random) - 1.2,
                                 2.5 * unit(random) - 1.2, 2.5 * unit(random) - 1.2));
    }
    compare_with_all_distances(Model(joined(scene)));
  }
}

TEST(find_links_test, nested_spheres_can_be_cancelled)
{
  struct Visitor
  {
    int last, number = 0;
    bool on_progress(const char*, double) { return ++number < last; }
  };
  std::vector<Soup> spheres;
  for (int i = 0; i < 20; ++i)
    spheres.push_back(scaled(sphere(3), 1 + 0.04 * i));
  const Soup scene = joined(spheres);
  const auto read = [&](Visitor& visitor, bool links) {
    return RS::make_surface_of_polygon_soup(
      scene.points, scene.polygons,
      RS::parameters::visitor(std::ref(visitor)).component_links(links));
  };
  Visitor without{1000000}, all{1000000};
  read(without, false);
  read(all, true);
  EXPECT_GT(all.number, without.number + 20) << "also while pairs of faces are compared";
  Visitor cancelling{all.number - 5};
  EXPECT_THROW(read(cancelling, true), RS::Segmentation_cancelled);
}

// Of faces that are as near, another one may be taken.
TEST(find_links_test, lengths_of_contact_hardly_depend_on_the_order_of_faces)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Soup> parts = {sphere(3), scaled(torus(15, 15, 0.75), 0.4),
                             translated(square(2), -0.3, -0.4, 0.95)};
  for (int i = 0; i < 60; ++i)
    parts.push_back(translated(scaled(sphere(1), 0.1 * unit(random)), 2 * unit(random),
                               2 * unit(random), 2 * unit(random)));
  Soup scene = joined(parts);
  const double length = checked_length(scene);
  shuffle_faces(scene, random);
  EXPECT_NEAR(length, checked_length(scene), 0.1 * length);
}

TEST(find_links_test, any_finite_coordinates)
{
  const Soup scene = joined({box_of_sheets(2),
                             translated(scaled(box_of_sheets(1), 0.3), 0.33, 0.41, 1),
                             translated(scaled(sphere(2), 0.1), 3, 0, 0)});
  const double expected = checked_length(scene);
  for (double scale : {1e150, 1e-150, 1e300, 1e-290, 1e19, 1e-19}) {
    const Model m(scaled(scene, scale));
    EXPECT_NEAR(checked_length(m) * (m.surface.unit() / scale), expected, 1e-6) << scale;
  }
  const Soup tiny = scaled(scene, 1e-150);
  checked_length(joined({scene, tiny, translated(tiny, 1, 2, 3), scaled(scene, 1e-12)}));
  checked_length(joined(scaled(scene, 1e150), tiny));
  EXPECT_NEAR(checked_length(translated(scene, 1000, 2000, -3000)), expected, 1e-6);
}

TEST(find_links_test, degenerate_faces)
{
  const auto face = [](const Point& p, const Point& q, const Point& r) {
    return Soup{{p, q, r}, {{0, 1, 2}}};
  };
  const Soup point = face({0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, 0.5, 2}),
             line = face({0, 0, 3}, {1, 1, 3}, {2, 2, 3}), box = box_of_sheets(1);
  EXPECT_EQ(checked_length(joined({point, point, point})), 0);
  EXPECT_EQ(
    checked_length(joined({point, box, line, line, face({0, 0, 0}, {1, 1, 1}, {0.5, 0.5, 0.5})})),
    0);
  Soup with_line = box;
  with_line.polygons.push_back({0, 0, 1});
  EXPECT_NEAR(checked_length(joined({with_line, translated(box, 0, 0, 1), point})), 4, 1e-6);
}

// Each two cross near the origin: 5.5 million pairs.
TEST(find_links_test, a_face_has_one_link_of_contact)
{
  constexpr std::size_t number = 3332;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Soup soup;
  for (std::size_t i = 0; i < number; ++i) {
    const RS::Double_3 d = {normal(random), normal(random), normal(random)}, p = 1 / norm(d) * d;
    soup.points.push_back({p.x, p.y, p.z});
    soup.points.push_back({-p.x, -p.y, -p.z});
    soup.points.push_back({0.01, i % 2 ? 0.01 : -0.01, 0.01});
    soup.polygons.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Model m(soup);
  checked_length(m);
  EXPECT_LE(m.links.size(), 2 * number);
}

// Each touches all others in one point.
TEST(find_links_test, thousands_of_triangles_share_a_vertex)
{
  constexpr std::size_t number = 15000;
  Soup soup{{{0, 0, 0}}, {}};
  for (std::size_t i = 0; i < 2 * number; ++i)
    soup.points.push_back({std::cos(i), std::sin(i), double(i) / (2.0 * number)});
  for (std::size_t i = 0; i < number; ++i)
    soup.polygons.push_back({0, 2 * i + 1, 2 * i + 2});
  const std::clock_t start = std::clock();
  const Model m(soup);
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 1);
  checked_length(m);
  EXPECT_LE(m.links.size(), 2 * number);
  std::vector<std::size_t> degrees(number);
  for (const Link& l : m.links) {
    ++degrees[l.lower];
    ++degrees[l.higher];
  }
  EXPECT_LT(*std::max_element(degrees.begin(), degrees.end()), 1000u) << "a hub is slow to merge";
}

// Most boxes are inside most larger ones.
TEST(find_links_test, triangles_of_all_sizes)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-30, 30), sign(-1, 1);
  Soup soup;
  for (std::size_t i = 0; i < 12000; ++i) {
    Point p;
    for (double& x : p)
      x = std::copysign(std::pow(10, exponent(random)), sign(random));
    soup.points.push_back(p);
    if (i % 3 == 2)
      soup.polygons.push_back({i - 2, i - 1, i});
  }
  const std::clock_t start = std::clock();
  const Model m(soup);
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 4);
  checked_length(m);
}

/// Whether closed parts look outwards in their surface, where some are given inside out. A part
/// inside others is a void or not as it is given beside the outermost part around it.
std::vector<bool> look_outwards(const std::vector<Soup>& parts,
                                const std::vector<std::size_t>& inside_out)
{
  std::vector<Soup> given = parts;
  for (std::size_t i : inside_out)
    given[i] = reversed(given[i]);
  const RS::Surface surface = RS::make_surface(to_surface_mesh(joined(given)));
  std::vector<bool> result;
  std::size_t f = 0;
  for (const Soup& part : parts) {
    const RS::Double_3 origin = surface.centroid(f);
    double volume = 0;
    for (const std::size_t end = f + part.polygons.size(); f < end; ++f)
      volume += surface.area(f) * dot(surface.centroid(f) - origin, surface.normal(f));
    result.push_back(volume > 0);
  }
  return result;
}

TEST(find_nesting_test, aligned_boxes)
{
  // In a box: flush with three of its sides, in the middle, flush with the others; then the box
  // itself; on its top, below, beside.
  const Soup box = triangulated(cube()), half = scaled(box, 0.5);
  const std::vector<Soup> parts = {half,
                                   translated(half, 0.25, 0.25, 0.25),
                                   translated(half, 0.5, 0.5, 0.5),
                                   box,
                                   translated(box, 0, 0, 1),
                                   translated(half, 0, 0, -0.5),
                                   translated(half, 1, 0, 0)};
  const std::vector<bool> all(7, true);
  EXPECT_EQ(look_outwards(parts, {}), all);
  EXPECT_EQ(look_outwards(parts, {4, 5, 6}), all);
  EXPECT_EQ(look_outwards(parts, {3}), (std::vector<bool>{false, false, false, 1, 1, 1, 1}));
}

TEST(find_nesting_test, linked_tori_and_a_sphere_in_the_hole)
{
  const Soup ring = scaled(torus(40, 40, 0.5), 0.5), ball = scaled(sphere(2), 0.1);
  const Soup upright = mapped(ring, [](const Point& p) { return Point{p[0] + 1, p[2], -p[1]}; });
  const std::vector<Soup> parts = {ring, upright, ball, translated(ball, 1, 0, 0.01),
                                   translated(ball, -1, 0, 0.02)};
  EXPECT_EQ(look_outwards(parts, {0}), (std::vector<bool>{true, true, true, false, false}));
  EXPECT_EQ(look_outwards(parts, {1}), (std::vector<bool>{true, true, false, true, true}));
}

TEST(find_nesting_test, open_components_contain_nothing)
{
  Soup open = sphere(2);
  open.polygons.pop_back();
  EXPECT_TRUE(look_outwards({open, scaled(sphere(2), 0.5)}, {0})[1]);
  EXPECT_FALSE(look_outwards({sphere(2), scaled(open, 0.5)}, {1})[1]) << "it is as given";
}

TEST(find_nesting_test, random_spheres_in_spheres_in_any_position)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Soup> parts;
  std::vector<std::size_t> outermost;
  std::vector<bool> expected;
  for (std::size_t i = 0; i < 100; ++i) { // each with one inside, and one inside that
    const Point at{10 * double(i % 10), 10 * double(i / 10), 3 * unit(random)};
    for (int j = 0; j < 3; ++j) {
      const double r = std::pow(0.3, j) * 3, move = j == 0 ? 1 : 0.3 * r;
      if (j == 0)
        outermost.push_back(parts.size());
      parts.push_back(translated(scaled(sphere(1 + i % 2), r), at[0] + move * unit(random),
                                 at[1] + move * unit(random), at[2] + move * unit(random)));
      expected.push_back(j == 0);
    }
  }
  EXPECT_EQ(look_outwards(parts, outermost), expected);
}

} // namespace find_links_test
