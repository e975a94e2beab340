// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Region_segmentation/Surface/internal/components.h>
#include <CGAL/Region_segmentation/Surface/internal/find_links.h>
#include <CGAL/Region_segmentation/Surface/internal/orient_faces.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace find_links_test {

namespace RS = CGAL::Region_segmentation;
using RS::Double_3;
using RS::Partition;
using RS::Surface;
using RS::internal::Added_adjacency;
using RS::internal::squared_distance;
using Index = Surface::Index;

/// Points and polygons.
struct Soup
{
  std::vector<Double_3> points;
  std::vector<std::vector<Index>> polygons;

  void add(const Soup& other)
  {
    const Index first = Index(points.size());
    points.insert(points.end(), other.points.begin(), other.points.end());
    for (auto polygon : other.polygons) {
      for (Index& v : polygon)
        v += first;
      polygons.push_back(polygon);
    }
  }

  template <typename F>
  Soup transformed(const F& f) const
  {
    Soup result = *this;
    for (Double_3& p : result.points)
      p = f(p);
    return result;
  }
  Soup moved(double x, double y, double z) const
  {
    return transformed([&](const Double_3& p) { return Double_3{p.x + x, p.y + y, p.z + z}; });
  }
  Soup scaled(double s) const
  {
    return transformed([&](const Double_3& p) { return s * p; });
  }
};

bool is_before(const Added_adjacency& a, const Added_adjacency& b)
{
  return std::tie(a.higher, a.lower) < std::tie(b.higher, b.lower);
}

/// A surface with the edges of polygons, whose sides are neither sewn nor turned.
struct Bare_surface : Surface
{
  /// Returns the components.
  Partition fill(const Soup& soup)
  {
    double largest = 0;
    for (const Double_3& p : soup.points)
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    m_unit = !(largest > 0) || std::abs(std::ilogb(largest)) <= 64
               ? 1
               : std::ldexp(1.0, std::ilogb(largest));
    for (const Double_3& p : soup.points)
      m_points.push_back({p.x / m_unit, p.y / m_unit, p.z / m_unit});
    std::map<std::pair<Index, Index>, Index> face_of;
    RS::internal::Lowest_root_forest forest(soup.polygons.size());
    for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
      const auto& polygon = soup.polygons[f];
      m_corners.insert(m_corners.end(), polygon.begin(), polygon.end());
      m_first_corners.push_back(Index(m_corners.size()));
      Double_3 n{0, 0, 0};
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Index v = polygon[i], w = polygon[(i + 1) % polygon.size()];
        n = n + cross(m_points[v] - m_points[polygon[0]], m_points[w] - m_points[polygon[0]]);
        const auto [place, is_new] = face_of.emplace(std::minmax(v, w), Index(f));
        if (!is_new) {
          m_lower_faces.push_back(place->second);
          m_higher_faces.push_back(Index(f));
          m_squared_lengths.push_back(squared_norm(m_points[v] - m_points[w]));
          m_flags.push_back(0);
          forest.unite(place->second, Index(f));
        }
      }
      const double length = norm(n);
      m_areas.push_back(length / 2);
      m_normals.push_back(length > 0 ? (1 / length) * n : Double_3{0, 0, 0});
      m_area += length / 2;
    }
    return forest.take_partition();
  }
};

/// A surface with edges, and its components.
struct Model
{
  explicit Model(const Soup& soup)
    : component_of(surface.fill(soup))
  {}

  std::vector<Added_adjacency> links() const
  {
    auto result = RS::internal::find_links(surface, component_of, RS::Execution());
    std::sort(result.begin(), result.end(), is_before);
    return result;
  }

  std::vector<Index> outermost() const
  {
    return outermost_of_closed(std::vector<bool>(component_of.number_of_parts(), true));
  }

  std::vector<Index> outermost_of_closed(const std::vector<bool>& is_closed) const
  {
    return RS::internal::find_outermost(surface, component_of, is_closed);
  }

  Bare_surface surface;
  Partition component_of;
};

/// A grid of n x n squares, each of two triangles, on the unit square of the plane z = 0.
Soup square(std::size_t n)
{
  Soup s;
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
      s.points.push_back({double(i) / double(n), double(j) / double(n), 0});
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const Index a = Index(j * (n + 1) + i), b = a + 1, c = Index(a + n + 2), d = c - 1;
      s.polygons.push_back({a, b, c});
      s.polygons.push_back({a, c, d});
    }
  return s;
}

/// The unit cube, with edges divided into n.
Soup box(std::size_t n = 1)
{
  std::map<std::array<Index, 3>, Index> vertices;
  Soup s;
  const auto vertex = [&](std::array<Index, 3> p) {
    const auto [place, is_new] = vertices.emplace(p, Index(s.points.size()));
    if (is_new)
      s.points.push_back(
        {double(p[0]) / double(n), double(p[1]) / double(n), double(p[2]) / double(n)});
    return place->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (Index side = 0; side < 2; ++side)
      for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
          const auto corner = [&](Index x, Index y) {
            std::array<Index, 3> p;
            p[axis] = side * Index(n);
            p[(axis + 1) % 3] = x;
            p[(axis + 2) % 3] = y;
            return vertex(p);
          };
          Index a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                d = corner(i, j + 1);
          if (side == 0)
            std::swap(b, d);
          s.polygons.push_back({a, b, c});
          s.polygons.push_back({a, c, d});
        }
  return s;
}

/// A box as a sphere of radius 1.
Soup sphere(std::size_t n)
{
  return box(n).transformed([](const Double_3& p) {
    const Double_3 q = p - Double_3{0.5, 0.5, 0.5};
    return 1 / norm(q) * q;
  });
}

/// Around the z axis.
Soup torus(double radius, double tube, std::size_t n)
{
  constexpr double pi = 3.14159265358979323846;
  Soup s;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double a = 2 * pi * double(i) / double(n), b = 2 * pi * double(j) / double(n);
      const double r = radius + tube * std::cos(b);
      s.points.push_back({r * std::cos(a), r * std::sin(a), tube * std::sin(b)});
      const auto v = [&](std::size_t k, std::size_t l) { return Index((k % n) * n + l % n); };
      s.polygons.push_back({v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1)});
    }
  return s;
}

Soup together(const std::vector<Soup>& soups)
{
  Soup result;
  for (const Soup& s : soups)
    result.add(s);
  return result;
}

double length_of_contact(const std::vector<Added_adjacency>& links)
{
  double sum = 0;
  for (const Added_adjacency& l : links)
    sum += std::sqrt(l.squared_length);
  return sum;
}

/// What holds for all links: different components, and everything connected; at most one
/// link for a pair of faces.
void check(const Model& m, const std::vector<Added_adjacency>& links)
{
  RS::internal::Lowest_root_forest forest(m.component_of.number_of_parts());
  std::size_t number = m.component_of.number_of_parts();
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Added_adjacency& l = links[i];
    EXPECT_LT(l.lower, l.higher);
    EXPECT_NE(m.component_of[l.lower], m.component_of[l.higher]);
    EXPECT_GE(std::sqrt(l.squared_length), 0);
    EXPECT_TRUE(std::isfinite(std::sqrt(l.squared_length)));
    EXPECT_FALSE(i > 0 && is_before(l, links[i - 1]));
    number -= forest.unite(m.component_of[l.lower], m.component_of[l.higher]);
  }
  EXPECT_EQ(number, m.component_of.number_of_parts() > 0 ? 1u : 0u);
}

double checked_length(const Soup& soup)
{
  const Model m(soup);
  const auto links = m.links();
  check(m, links);
  return length_of_contact(links);
}

TEST(find_links_test, one_component_or_none_has_no_links)
{
  EXPECT_TRUE(Model(box()).links().empty());
  EXPECT_TRUE(Model(Soup()).links().empty());
}

/// The length of contact of a model is about what is expected, however fine its faces are.
void expect_length(const Soup& soup, double expected)
{
  const double length = checked_length(soup);
  EXPECT_GT(length, expected / 3);
  EXPECT_LT(length, expected * 3.5);
}

TEST(find_links_test, crossing_boxes_have_about_the_length_of_the_intersection)
{
  const auto bar = [](const Double_3& p) {
    return Double_3{0.31 + 0.2 * p.x, 0.27 + 0.3 * p.y, -1 + 3.01 * p.z};
  };
  for (const std::size_t n : {1, 2, 7, 30})
    for (const std::size_t m : {1, 2, 7, 30}) {
      SCOPED_TRACE(std::to_string(n) + ' ' + std::to_string(m));
      expect_length(together({box(n), box(m).transformed(bar)}), 2 * (2 * 0.2 + 2 * 0.3));
    }
}

TEST(find_links_test, a_box_on_another_has_about_the_border_of_the_contact_area)
{
  for (double gap : {0.0, 0.001, -0.001})
    for (std::size_t n : {1, 5, 20})
      for (std::size_t m : {1, 8, 40}) {
        SCOPED_TRACE(std::to_string(gap) + ' ' + std::to_string(n) + ' ' + std::to_string(m));
        const Soup leg = box(n).scaled(0.3).moved(0.33, 0.41, 1 + gap);
        expect_length(together({box(m), leg}), 4 * 0.3);
        expect_length(together({leg, box(m)}), 4 * 0.3);
        // side by side, of the same size
        expect_length(together({box(n), box(m).moved(0, 0, 1 + gap)}), 4);
      }
}

TEST(find_links_test, a_contact_of_faces_smaller_than_the_tolerance_has_about_its_border)
{
  expect_length(together({box(100), box(100).moved(0.052, 0.013, 1)}), 2 * (0.948 + 0.987));
}

TEST(find_links_test, components_that_coincide_are_linked)
{
  for (const Soup& soup : {box(3), sphere(5)})
    EXPECT_GE(Model(together({soup, soup})).links().size(), soup.polygons.size());
}

TEST(find_links_test, sheets_touch_along_their_border)
{
  const auto wall = [](const Double_3& p) { return Double_3{0.3 + 0.5 * p.x, 0.37, p.y}; };
  const auto rotated = [](const Double_3& p) {
    return Double_3{0.3 + 0.5 * p.x, 0.3 + 0.2 * p.x, p.y};
  };
  for (std::size_t n : {6, 50})
    for (std::size_t m : {10, 40})
      for (double gap : {0.0, 0.0004, -0.0004}) {
        SCOPED_TRACE(std::to_string(n) + ' ' + std::to_string(m) + ' ' + std::to_string(gap));
        const auto floor = square(m);
        expect_length(together({floor, square(n).transformed(wall).moved(0, 0, gap)}), 0.5);
        expect_length(together({floor, square(n).transformed(rotated).moved(0, 0, gap)}),
                      std::hypot(0.5, 0.2));
        // in one plane, edge to edge, with other vertices
        expect_length(together({floor, square(n).moved(1 + gap, 0, 0)}), 1);
      }
}

TEST(find_links_test, a_crumb_joins_the_nearest_component)
{
  const Soup floor = square(1).scaled(100);
  const Soup crumb = sphere(4).scaled(0.01);
  const Soup scene = together(
    {floor, box().moved(40, 40, 3), crumb.moved(60, 30, 0.5), crumb.moved(40.5, 40.5, 3.5)});
  const Model m(scene);
  const auto links = m.links();
  check(m, links);
  std::set<std::pair<Index, Index>> pairs;
  for (const Added_adjacency& l : links) {
    EXPECT_EQ(std::sqrt(l.squared_length), 0);
    pairs.emplace(m.component_of[l.lower], m.component_of[l.higher]);
  }
  EXPECT_EQ(pairs, (std::set<std::pair<Index, Index>>{{0, 1}, {0, 2}, {1, 3}}));
  EXPECT_EQ(links.size(), 3u);
}

/// The weight of a minimum spanning tree of the components by the distance of their nearest faces,
/// compared with the links of length 0 after those of contact.
void compare_with_all_distances(const Model& m, const std::vector<Added_adjacency>& links)
{
  using RS::internal::Triangle;
  const auto triangle = [&](std::size_t f) {
    return Triangle{m.surface.point(m.surface.corner(f, 0)),
                    m.surface.point(m.surface.corner(f, 1)),
                    m.surface.point(m.surface.corner(f, 2))};
  };
  const std::size_t n = m.component_of.number_of_parts();
  std::vector<std::tuple<double, Index, Index>> pairs;
  for (Index f = 0; f < m.component_of.size(); ++f)
    for (Index g = 0; g < f; ++g)
      if (m.component_of[f] != m.component_of[g])
        pairs.emplace_back(squared_distance(triangle(f), triangle(g)), g, f);
  std::sort(pairs.begin(), pairs.end());
  RS::internal::Lowest_root_forest forest(n), expected_forest(n);
  const auto unite = [&](auto& groups, Index f, Index g) {
    return groups.unite(m.component_of[f], m.component_of[g]);
  };
  std::set<std::pair<Index, Index>> expected, found;
  std::vector<std::tuple<double, Index, Index>> gaps;
  for (const Added_adjacency& l : links)
    if (l.squared_length > 0) {
      unite(forest, l.lower, l.higher);
      unite(expected_forest, l.lower, l.higher);
    } else
      gaps.emplace_back(squared_distance(triangle(l.lower), triangle(l.higher)), l.lower, l.higher);
  std::sort(gaps.begin(), gaps.end());
  for (const auto& [d, g, f] : gaps) // some may be contacts of small components
    if (unite(forest, g, f))
      found.emplace(g, f);
  for (const auto& [d, g, f] : pairs)
    if (unite(expected_forest, g, f))
      expected.emplace(g, f);
  // The same components, and the same length together; several faces share a nearest point.
  ASSERT_EQ(found.size(), expected.size());
  double sum = 0, expected_sum = 0;
  for (const auto& [g, f] : found)
    sum += std::sqrt(squared_distance(triangle(f), triangle(g)));
  for (const auto& [g, f] : expected)
    expected_sum += std::sqrt(squared_distance(triangle(f), triangle(g)));
  EXPECT_NEAR(sum, expected_sum, 1e-6 * (1 + expected_sum));
  std::set<std::pair<Index, Index>> expected_components;
  for (const auto& [g, f] : expected)
    expected_components.insert(std::minmax(m.component_of[g], m.component_of[f]));
  std::size_t equal = 0;
  for (const auto& [g, f] : found)
    equal += expected_components.count(std::minmax(m.component_of[g], m.component_of[f]));
  EXPECT_GE(equal + 1 + found.size() / 20, found.size());
}

/// By another implementation.
double squared_distance_of_cgal(const RS::internal::Triangle& s, const RS::internal::Triangle& t)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  const auto triangle = [](const RS::internal::Triangle& corners) {
    const auto point = [](const Double_3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
    return Kernel::Triangle_3(point(corners[0]), point(corners[1]), point(corners[2]));
  };
  return CGAL::squared_distance(triangle(s), triangle(t));
}

TEST(find_links_test, distances_of_triangles)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto point = [&] { return Double_3{unit(random), unit(random), unit(random)}; };
  for (int i = 0; i < 3000; ++i) {
    RS::internal::Triangle s{point(), point(), point()}, t{point(), point(), point()};
    const Double_3 away{3 * unit(random) - 1.5, 0, 0};
    for (Double_3& p : t)
      p = (i % 3 == 0 ? 0.05 : 1) * p + away;
    if (i % 7 == 0)
      t[i % 3] = s[1];
    const double expected = squared_distance_of_cgal(s, t);
    EXPECT_NEAR(squared_distance(s, t), expected, 1e-9);
    EXPECT_NEAR(squared_distance(t, s), expected, 1e-9);
    EXPECT_LE(RS::internal::squared_separation(s, t), expected + 1e-12);
  }
}

TEST(find_links_test, nested_spheres_are_linked_as_by_all_distances)
{
  Soup scene;
  for (int i = 0; i < 8; ++i)
    scene.add(sphere(5).scaled(1 + 0.1 * i + 0.01 * i * i).moved(0.003 * i, 0.001 * i, 0));
  const Model m(scene);
  const auto links = m.links();
  EXPECT_EQ(links.size(), 7u);
  compare_with_all_distances(m, links);
}

TEST(find_links_test, nested_spheres_can_be_cancelled)
{
  struct Visitor
  {
    int number = 0, last;
    bool on_progress(const char*, double) { return ++number < last; }
  };
  Soup scene;
  for (int i = 0; i < 30; ++i)
    scene.add(sphere(10).scaled(1 + 0.04 * i));
  const Model m(scene);
  const auto links = [&](Visitor& visitor) {
    return RS::internal::find_links(m.surface, m.component_of,
                                    RS::Execution().with_visitor(visitor));
  };
  Visitor all{0, 1000000};
  EXPECT_EQ(links(all).size(), 29u);
  EXPECT_GT(all.number, 20) << "also while pairs of faces are compared";
  Visitor cancelling{0, all.number - 5};
  EXPECT_THROW(links(cancelling), RS::Segmentation_cancelled);
}

std::vector<Index> random_order(std::size_t size, std::mt19937& random)
{
  std::vector<Index> order(size);
  std::iota(order.begin(), order.end(), Index(0));
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

Soup in_order(const Soup& soup, const std::vector<Index>& order)
{
  Soup result{soup.points, {}};
  for (const Index f : order)
    result.polygons.push_back(soup.polygons[f]);
  return result;
}

TEST(find_links_test, random_crumbs_are_linked_as_by_all_distances)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 2; ++round) {
    Soup scene = round % 2 == 0 ? sphere(5) : square(1).scaled(3);
    for (int i = 0; i < 200; ++i) {
      const double size = std::pow(10, -1 - 3 * unit(random));
      Soup crumb = i % 5 == 0 ? box() : square(1 + std::size_t(i) % 2);
      crumb = crumb.transformed([&](const Double_3& p) {
        return Double_3{p.x + 0.2 * unit(random), p.y + 0.2 * unit(random),
                        p.z + 0.2 * unit(random)};
      });
      scene.add(crumb.scaled(size).moved(2.5 * unit(random) - 1.2, 2.5 * unit(random) - 1.2,
                                         2.5 * unit(random) - 1.2));
    }
    const Model m(scene);
    const auto links = m.links();
    check(m, links);
    compare_with_all_distances(m, links);
  }
}

// Of faces that are as near, another one may be taken.
TEST(find_links_test, lengths_of_contact_hardly_depend_on_the_order_of_faces)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Soup scene = together({sphere(8), torus(0.8, 0.3, 15), square(2).moved(-0.3, -0.4, 0.95)});
  for (int i = 0; i < 60; ++i)
    scene.add(sphere(2)
                .scaled(0.1 * unit(random))
                .moved(2 * unit(random), 2 * unit(random), 2 * unit(random)));
  const std::vector<Index> order = random_order(scene.polygons.size(), random);
  const Soup shuffled = in_order(scene, order);
  const double length = checked_length(scene);
  EXPECT_NEAR(length, checked_length(shuffled), 0.1 * length);
}

TEST(find_links_test, any_finite_coordinates)
{
  const Soup scene = together(
    {box(2), box().scaled(0.3).moved(0.33, 0.41, 1), sphere(3).scaled(0.1).moved(3, 0, 0)});
  const double expected = checked_length(scene);
  for (double scale : {1e150, 1e-150, 1e300, 1e-290, 1e19, 1e-19}) {
    const double length = checked_length(scene.scaled(scale));
    const Model m(scene.scaled(scale));
    EXPECT_NEAR(length * (m.surface.unit() / scale), expected, 1e-6) << scale;
  }
  checked_length(together(
    {scene, scene.scaled(1e-150), scene.scaled(1e-150).moved(1, 2, 3), scene.scaled(1e-12)}));
  checked_length(together({scene.scaled(1e150), scene.scaled(1e-150)}));
  EXPECT_NEAR(checked_length(scene.moved(1000, 2000, -3000)), expected, 1e-6);
}

TEST(find_links_test, degenerate_faces)
{
  const auto face = [](const Double_3& p, const Double_3& q, const Double_3& r) {
    Soup s;
    s.points = {p, q, r};
    s.polygons = {{0, 1, 2}};
    return s;
  };
  const Soup point = face({0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, 0.5, 2}),
             line = face({0, 0, 3}, {1, 1, 3}, {2, 2, 3});
  EXPECT_EQ(checked_length(together({point, point, point})), 0);
  EXPECT_EQ(checked_length(
              together({point, box(), line, line, face({0, 0, 0}, {1, 1, 1}, {0.5, 0.5, 0.5})})),
            0);
  Soup crossed_by_line = box();
  crossed_by_line.polygons.push_back({0, 0, 1});
  EXPECT_NEAR(checked_length(together({crossed_by_line, box().moved(0, 0, 1), point})), 4, 1e-6);
}

// Each two cross near the origin: 5.5 million pairs.
TEST(find_links_test, a_face_has_one_link_of_contact)
{
  constexpr Index number = 3332;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Soup soup;
  for (Index i = 0; i < number; ++i) {
    const Double_3 d = {normal(random), normal(random), normal(random)}, p = 1 / norm(d) * d;
    soup.points.push_back(p);
    soup.points.push_back(-1.0 * p);
    soup.points.push_back({0.01, i % 2 ? 0.01 : -0.01, 0.01});
    soup.polygons.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Model m(soup);
  const auto links = m.links();
  check(m, links);
  EXPECT_LE(links.size(), 2 * number);
}

// Each touches all others in one point.
TEST(find_links_test, thousands_of_triangles_share_a_vertex)
{
  constexpr Index number = 15000;
  Soup soup;
  soup.points.push_back({0, 0, 0});
  for (Index i = 0; i < 2 * number; ++i)
    soup.points.push_back({std::cos(i), std::sin(i), i / (2.0 * number)});
  for (Index i = 0; i < number; ++i)
    soup.polygons.push_back({0, 2 * i + 1, 2 * i + 2});
  const Model m(soup);
  const std::clock_t start = std::clock();
  const auto links = m.links();
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 1);
  check(m, links);
  EXPECT_LE(links.size(), 2 * number);
  std::vector<std::size_t> degrees(number);
  for (const Added_adjacency& l : links) {
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
  for (Index i = 0; i < 4000; ++i) {
    for (int k = 0; k < 3; ++k) {
      const auto coordinate = [&] {
        return std::copysign(std::pow(10, exponent(random)), sign(random));
      };
      const double x = coordinate(), y = coordinate();
      soup.points.push_back({x, y, coordinate()});
    }
    soup.polygons.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Model m(soup);
  const std::clock_t start = std::clock();
  const auto links = m.links();
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 4);
  check(m, links);
}

TEST(find_nesting_test, aligned_boxes)
{
  // In a box: flush with three of its sides, with all of one, in the middle, and on its top; below,
  // beside.
  const Soup b = box();
  const Model m(together({b.scaled(0.5), b.scaled(0.5).moved(0.25, 0.25, 0.25),
                          b.scaled(0.5).moved(0.5, 0.5, 0.5), b, b.moved(0, 0, 1),
                          b.scaled(0.5).moved(0, 0, -0.5), b.scaled(0.5).moved(1, 0, 0), b}));
  const auto outermost = m.outermost();
  EXPECT_EQ(outermost[0], 3u);
  EXPECT_EQ(outermost[1], 3u);
  EXPECT_EQ(std::vector<Index>(outermost.begin() + 3, outermost.end()),
            (std::vector<Index>{3, 4, 5, 6, 7}));
}

TEST(find_nesting_test, linked_tori_and_a_sphere_in_the_hole)
{
  const Soup t = torus(1, 0.25, 40);
  const Soup upright = t.transformed([](const Double_3& p) { return Double_3{p.x + 1, p.z, p.y}; });
  const Soup ball = sphere(4).scaled(0.1);
  const Model m(together({t, upright, ball, ball.moved(1, 0, 0.01), ball.moved(-1, 0, 0.02)}));
  const auto outermost = m.outermost();
  EXPECT_EQ(outermost, (std::vector<Index>{0, 1, 1, 0, 0}));
}

TEST(find_nesting_test, open_components_contain_nothing)
{
  const Model m(together({sphere(4), sphere(4).scaled(0.5)}));
  EXPECT_EQ(m.outermost_of_closed({false, true}), (std::vector<Index>{0, 1}));
  EXPECT_EQ(m.outermost_of_closed({true, false}), (std::vector<Index>{0, 1}));
}

TEST(find_nesting_test, random_spheres_in_spheres_in_any_position)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Soup> soups;
  std::vector<Index> expected;
  for (Index i = 0; i < 100; ++i) { // each with one inside, and one inside that
    const Double_3 at{10 * double(i % 10), 10 * double(i / 10), 3 * unit(random)};
    for (Index j = 0; j < 3; ++j) {
      const double r = std::pow(0.3, j) * 3, move = j == 0 ? 1 : 0.3 * r;
      soups.push_back(sphere(2 + i % 4).scaled(r).moved(
        at.x + move * unit(random), at.y + move * unit(random), at.z + move * unit(random)));
      expected.push_back(3 * i);
    }
  }
  EXPECT_EQ(Model(together(soups)).outermost(), expected);
}

} // namespace find_links_test
