// SPDX-License-Identifier: GPL-3.0-or-later

// The surface of a mesh, compared with a polygon soup without an order of faces; and that of points
// and polygons.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;
using RS::Double_3;

namespace Surface_test {

using Pairs = std::set<std::pair<std::size_t, std::size_t>>; // of faces, the lower one first

Polygon corners_of(const RS::Surface& surface, std::size_t face)
{
  return {surface.corners(face).begin(), surface.corners(face).end()};
}

/// Faces, length and flags of adjacencies, in their order.
using Adjacencies = std::vector<std::tuple<std::size_t, std::size_t, double, int>>;
Adjacencies adjacencies_of(const RS::Surface& surface)
{
  Adjacencies result;
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    result.emplace_back(surface.lower_face(a), surface.higher_face(a), surface.length(a),
                        surface.flags(a));
  return result;
}

Pairs pairs_with_flags(const RS::Surface& surface, std::uint8_t any)
{
  Pairs result;
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (surface.has_flag(a, any))
      result.insert({surface.lower_face(a), surface.higher_face(a)});
  return result;
}

Double_3 vector(const Point& p)
{
  return {p[0], p[1], p[2]};
}

/// A bumpy sheet of several blocks of triangles and squares in any order; its points are not in one
/// plane.
Soup mixed_sheet(std::mt19937& random)
{
  Soup soup = grid(90, 80);
  std::vector<Polygon> polygons;
  for (const Polygon& p : soup.polygons)
    if (random() % 3 == 0)
      polygons.push_back(p);
    else {
      polygons.push_back({p[0], p[1], p[2]});
      polygons.push_back({p[0], p[2], p[3]});
    }
  soup.polygons = std::move(polygons);
  bump(soup, 0.3, random);
  shuffle_faces(soup, random);
  return soup;
}

/// Half the sum of the cross products around the mean of the corners.
Double_3 area_vector(const Soup& soup, const Polygon& polygon)
{
  Double_3 center{}, sum{};
  for (std::size_t v : polygon)
    center = center + (1.0 / double(polygon.size())) * vector(soup.points[v]);
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum = sum + cross(vector(soup.points[polygon[i]]) - center,
                      vector(soup.points[polygon[(i + 1) % polygon.size()]]) - center);
  return 0.5 * sum;
}

/// From where to where a polygon goes along an edge.
std::pair<std::size_t, std::size_t> side_of(const Polygon& polygon, const Edge& edge)
{
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t u = polygon[i], v = polygon[(i + 1) % polygon.size()];
    if (make_edge(u, v) == edge)
      return {u, v};
  }
  throw std::logic_error("the polygon does not have the edge");
}

class Surface_test : public ::testing::TestWithParam<unsigned>
{
protected:
  void SetUp() override
  {
    std::mt19937 random(GetParam());
    soup = mixed_sheet(random);
    surface = RS::make_surface(to_surface_mesh(soup));
    ASSERT_GT(surface.number_of_faces(), 2 * RS::internal::block_size);
    ASSERT_EQ(surface.number_of_faces(), soup.polygons.size());
  }

  Soup soup;
  RS::Surface surface;
};

TEST_P(Surface_test, faces_have_their_corners_areas_and_normals)
{
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    Polygon expected = soup.polygons[f];
    std::rotate(expected.begin(), std::min_element(expected.begin(), expected.end()),
                expected.end());
    ASSERT_EQ(corners_of(surface, f), expected) << "face " << f << ", seed " << GetParam();
    const Double_3 a = area_vector(soup, expected);
    ASSERT_NEAR(surface.area(f), norm(a), 1e-12) << "face " << f << ", seed " << GetParam();
    ASSERT_LT(norm(surface.area(f) * surface.normal(f) - a), 1e-12)
      << "face " << f << ", seed " << GetParam();
  }
}

TEST_P(Surface_test, adjacencies_are_those_of_the_soup_by_higher_then_by_lower_face)
{
  std::map<std::pair<std::size_t, std::size_t>, Edge> expected;
  for (const auto& [edge, faces] : faces_of_edges(soup))
    if (faces.size() == 2)
      expected[{std::max(faces[0], faces[1]), std::min(faces[0], faces[1])}] = edge;
  ASSERT_EQ(surface.number_of_adjacencies(), expected.size());

  std::size_t e = 0, number_convex = 0, number_concave = 0;
  for (const auto& [faces, edge] : expected) {
    const auto [higher, lower] = faces;
    ASSERT_EQ(surface.higher_face(e), higher) << "edge " << e << ", seed " << GetParam();
    ASSERT_EQ(surface.lower_face(e), lower) << "edge " << e << ", seed " << GetParam();
    const auto [u, v] = side_of(soup.polygons[lower], edge);
    const Double_3 d = vector(soup.points[v]) - vector(soup.points[u]);
    const double sign = dot(cross(surface.normal(lower), surface.normal(higher)), d);
    ASSERT_GT(std::abs(sign), 1e-12) << "the oracle cannot tell";
    ASSERT_NEAR(surface.length(e), norm(d), 1e-14);
    ASSERT_EQ(surface.has_flag(e, RS::Surface::CONVEX), sign > 0)
      << "edge " << e << ", seed " << GetParam();
    ASSERT_EQ(surface.has_flag(e, RS::Surface::CONCAVE), sign < 0)
      << "edge " << e << ", seed " << GetParam();
    number_convex += sign > 0;
    number_concave += sign < 0;
    ++e;
  }
  EXPECT_GT(number_convex, 0u);
  EXPECT_GT(number_concave, 0u);
}

TEST_P(Surface_test, points_centroids_and_the_area_of_the_surface)
{
  ASSERT_EQ(surface.unit(), 1);
  ASSERT_EQ(surface.number_of_vertices(), soup.points.size());
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    for (double d : {surface.point(v).x - soup.points[v][0], surface.point(v).y - soup.points[v][1],
                     surface.point(v).z - soup.points[v][2]})
      ASSERT_EQ(d, 0) << "vertex " << v;
  double area = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    Double_3 center{};
    for (std::size_t v : soup.polygons[f])
      center = center + (1.0 / double(soup.polygons[f].size())) * vector(soup.points[v]);
    ASSERT_LT(norm(surface.centroid(f) - center), 1e-12) << "face " << f;
    area += surface.area(f);
  }
  EXPECT_EQ(surface.area(), area);
  EXPECT_EQ(surface.length_unit(), std::sqrt(area));
}

TEST_P(Surface_test, constraints_are_those_of_the_map)
{
  std::mt19937 random(GetParam());
  const std::set<Edge> constrained = random_edges(soup, 9, random);
  const Surface_mesh mesh = to_surface_mesh(soup);
  Pairs expected;
  for (const auto& [edge, faces] : faces_of_edges(soup))
    if (faces.size() == 2 && constrained.count(edge) > 0)
      expected.insert(std::minmax(faces[0], faces[1]));
  EXPECT_GT(expected.size(), 0u);
  EXPECT_EQ(pairs_with_flags(RS::make_surface(mesh, RS::parameters::edge_is_constrained_map(
                                                      edge_map(mesh, constrained))),
                             RS::Surface::CONSTRAINED),
            expected)
    << "seed " << GetParam();
}

INSTANTIATE_TEST_SUITE_P(seeds, Surface_test, ::testing::Values(1u, 2u));

TEST(Deviation_test, is_a_number_where_normals_are_equal_or_opposite)
{
  // Two unit squares in any plane, and two triangles back to back: rounding may bring the product
  // of unit normals beyond 1 or -1.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  std::size_t beyond = 0;
  for (int i = 0; i < 1000; ++i) {
    const Double_3 u{any(random), any(random), any(random)},
      v{any(random), any(random), any(random)};
    const auto on_plane = [&](const Point& p) -> Point {
      return {p[0] * u.x + p[1] * v.x, p[0] * u.y + p[1] * v.y, p[0] * u.z + p[1] * v.z};
    };
    const auto read = [&](const Soup& soup) {
      return RS::make_surface(to_surface_mesh(mapped(soup, on_plane)));
    };
    const RS::Surface surface = read(grid(2, 1)),
                      folded = read({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
    beyond += dot(surface.normal(0), surface.normal(0)) > 1;
    ASSERT_EQ(surface.number_of_adjacencies(), 1u);
    EXPECT_LE(surface.cosine(0), 1);
    EXPECT_NEAR(surface.deviation(0), 0, 1e-6) << "plane " << i;
    ASSERT_EQ(folded.number_of_adjacencies(), 3u);
    EXPECT_GE(folded.cosine(0), -1);
    EXPECT_NEAR(folded.deviation(0), std::acos(-1.0), 1e-6) << "plane " << i;
  }
  EXPECT_GT(beyond, 100u);
}

// Points and polygons

RS::Surface surface_of(const Soup& soup)
{
  return RS::make_surface_of_polygon_soup(soup.points, soup.polygons);
}

bool is_equal(const Double_3& a, const Double_3& b)
{
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// The same places, areas and normals; the vertices may have other numbers.
void expect_equal_shapes(const RS::Surface& a, const RS::Surface& b)
{
  ASSERT_EQ(a.number_of_faces(), b.number_of_faces());
  for (std::size_t f = 0; f < a.number_of_faces(); ++f) {
    ASSERT_TRUE(is_equal(a.normal(f), b.normal(f))) << "face " << f;
    ASSERT_EQ(a.area(f), b.area(f)) << "face " << f;
    ASSERT_EQ(a.number_of_corners(f), b.number_of_corners(f)) << "face " << f;
  }
  EXPECT_EQ(a.area(), b.area());
  EXPECT_EQ(a.unit(), b.unit());
  EXPECT_EQ(a.length_unit(), b.length_unit());
  EXPECT_EQ(adjacencies_of(a), adjacencies_of(b));
  EXPECT_EQ(a.has_seams_or_links(), b.has_seams_or_links());
}

void expect_equal(const RS::Surface& a, const RS::Surface& b)
{
  expect_equal_shapes(a, b);
  ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices());
  for (std::size_t f = 0; f < a.number_of_faces(); ++f)
    ASSERT_EQ(corners_of(a, f), corners_of(b, f)) << "face " << f;
}

/// The corners run counterclockwise seen from the side to which the normal points, from the lowest
/// vertex.
void expect_consistent_corners(const RS::Surface& surface)
{
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    const std::vector<std::size_t> corners = corners_of(surface, f);
    EXPECT_EQ(corners[0], *std::min_element(corners.begin(), corners.end())) << "face " << f;
    Double_3 twice{};
    for (std::size_t i = 2; i < corners.size(); ++i)
      twice = twice + cross(surface.point(corners[i - 1]) - surface.point(corners[0]),
                            surface.point(corners[i]) - surface.point(corners[0]));
    if (!surface.is_degenerate(f)) {
      EXPECT_LT(norm(0.5 * twice - surface.area(f) * surface.normal(f)), 1e-9 * surface.area(f))
        << "face " << f;
    }
  }
}

std::vector<std::size_t> with_flags(const RS::Surface& surface, std::uint8_t any)
{
  std::vector<std::size_t> result;
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (surface.has_flag(a, any))
      result.push_back(a);
  return result;
}

TEST(Surface_of_polygons_test, is_that_of_the_same_mesh)
{
  for (Family family : all_families)
    for (unsigned seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const Soup soup = random_mesh(family, seed);
      if (has_degenerate_faces(family)) // some points coincide: in a soup they are one
        EXPECT_EQ(surface_of(soup).number_of_faces(),
                  RS::make_surface(to_surface_mesh(soup)).number_of_faces());
      else
        expect_equal(surface_of(soup), RS::make_surface(to_surface_mesh(soup)));
    }
}

TEST(Surface_of_polygons_test, equal_points_are_one)
{
  const auto families = {Family::SHEET, Family::SPHERE, Family::TORUS, Family::BLOCKS};
  for_each_random_mesh(families, 2, [&](const Soup& given, unsigned) {
    const Soup soup = triangulated(given);
    const RS::Surface expected = surface_of(soup), surface = surface_of(torn(soup));
    ASSERT_EQ(surface.number_of_adjacencies(), expected.number_of_adjacencies());
    std::map<std::pair<std::size_t, std::size_t>, double> lengths; // two triangles share one edge
    for (std::size_t a = 0; a < expected.number_of_adjacencies(); ++a)
      lengths[{expected.lower_face(a), expected.higher_face(a)}] = expected.length(a);
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
      EXPECT_EQ(lengths.at({surface.lower_face(a), surface.higher_face(a)}), surface.length(a));
      EXPECT_EQ(surface.flags(a), expected.flags(a));
    }
    // Each point has the lowest number of those equal to it.
    std::map<Point, std::size_t> lowest;
    const Soup separate = torn(soup);
    for (std::size_t v = 0; v < separate.points.size(); ++v)
      lowest.emplace(separate.points[v], v);
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for (std::size_t v : corners_of(surface, f))
        EXPECT_EQ(lowest.at(separate.points[v]), v);
    expect_consistent_corners(surface);
  });
  // -0 is 0.
  const Soup two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -0.0, 0}, {0, -1, 0}, {1, 0, -0.0}},
                 {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(with_flags(surface_of(two), 0xff).size(), 0u) << "a flat edge";
  EXPECT_EQ(surface_of(two).number_of_adjacencies(), 1u);
}

// Two boxes that share a side, an edge, a corner, or all of them; an open one instead; with one
// more apart.
TEST(Surface_of_polygons_test, closed_components_that_share_points_are_as_in_a_face_graph)
{
  const Soup box = triangulated(cube());
  Soup open = box;
  open.polygons.pop_back();
  // So that diagonals of a shared side cross each other.
  const Soup mirrored = reversed(mapped(box, [](const Point& p) {
    return Point{1 - p[0], p[1], p[2]};
  }));
  std::vector<Soup> soups;
  for (const Point& place : {Point{1, 0, 0}, Point{1, 1, 0}, Point{1, 1, 1}, Point{0, 0, 0}})
    for (const Soup& other : {box, open, mirrored})
      soups.push_back(joined(joined(box, translated(other, place[0], place[1], place[2])),
                             translated(box, 3, 0, 0)));
  for (const Soup& soup : soups) {
    SCOPED_TRACE(std::to_string(&soup - soups.data()));
    expect_equal(surface_of(soup), RS::make_surface(to_surface_mesh(soup)));
  }
}

TEST(Surface_of_polygons_test, what_cannot_be_read_is_told)
{
  const auto message = [](const std::vector<Point>& points,
                          const std::vector<std::vector<long>>& polygons) {
    return message_of([&] { RS::make_surface_of_polygon_soup(points, polygons); });
  };
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(message(points, {{0, 1, 2}}), "taken");
  EXPECT_TRUE(contains(message(points, {{0, 1, 2}, {0, 1, 3}}), "polygon 1 has a corner 3"));
  EXPECT_TRUE(contains(message(points, {{0, -1, 2}}), "polygon 0 has a corner -1"));
  EXPECT_TRUE(contains(message(points, {{0, 1, 2}, {}}), "polygon 1 has no corners"));
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    for (std::size_t coordinate = 0; coordinate < 3; ++coordinate) {
      Soup soup{points, {{0, 1, 2}}};
      soup.points[1][coordinate] = bad;
      EXPECT_TRUE(contains(message(soup.points, {{0, 1, 2}}), "vertex 1 is not finite"));
      EXPECT_TRUE(contains(message_of([&] { RS::make_surface(to_surface_mesh(soup)); }),
                           "vertex 1 is not finite"));
    }
  EXPECT_EQ(RS::make_surface_of_polygon_soup(std::vector<Point>(), std::vector<Polygon>())
              .number_of_faces(),
            0u);
}

/// Squares of side 2 around an edge of length 2, at some angles in degrees, each once;
/// `is_reversed`: by square.
Soup sheets(const std::vector<double>& angles, const std::vector<bool>& is_reversed)
{
  Soup soup{{{0, 0, 0}, {0, 0, 2}}, {}};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double x = 2 * std::cos(angles[i] * CGAL_PI / 180),
                 y = 2 * std::sin(angles[i] * CGAL_PI / 180);
    const std::size_t n = soup.points.size();
    soup.points.insert(soup.points.end(), {{x, y, 2}, {x, y, 0}});
    soup.polygons.push_back({0, 1, n, n + 1});
    if (is_reversed[i])
      std::reverse(soup.polygons.back().begin(), soup.polygons.back().end());
  }
  return soup;
}

TEST(Seams_test,
     are_between_sheets_that_follow_each_other_and_have_angles_where_these_are_oriented_alike)
{
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::size_t m = 3 + seed % 6;
    std::vector<std::size_t> order(m); // the face at each place around the edge
    for (std::size_t i = 0; i < m; ++i)
      order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    std::vector<double> angles(m);
    std::vector<bool> is_reversed(m);
    double angle = double(random() % 360);
    for (std::size_t i = 0; i < m; ++i) {
      angles[order[i]] = angle;
      angle += 10 + double(random() % (300 / m));
      is_reversed[i] = random() % 2 == 0;
    }
    const RS::Surface surface = surface_of(sheets(angles, is_reversed));
    ASSERT_EQ(surface.number_of_adjacencies(), m);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> seam_of;
    for (std::size_t a = 0; a < m; ++a) {
      EXPECT_TRUE(surface.has_flag(a, RS::Surface::SEAM));
      EXPECT_EQ(surface.length(a), 1);
      seam_of[{surface.lower_face(a), surface.higher_face(a)}] = a;
    }
    ASSERT_EQ(seam_of.size(), m);
    for (std::size_t i = 0; i < m; ++i) {
      const std::size_t f = order[i], g = order[(i + 1) % m];
      ASSERT_EQ(seam_of.count(std::minmax(f, g)), 1u) << f << ' ' << g;
      const std::size_t a = seam_of[std::minmax(f, g)];
      EXPECT_EQ(surface.has_angle(a), is_reversed[f] != is_reversed[g]);
      if (is_reversed[f] == is_reversed[g])
        continue;
      // The wedge from f to g. A sheet that is not reversed looks to larger angles: into the wedge.
      double wedge = angles[g] - angles[f];
      wedge += wedge < 0 ? 360 : 0;
      const bool is_inside = !is_reversed[f];
      EXPECT_NEAR(surface.deviation(a), std::abs(180 - wedge) * CGAL_PI / 180, 1e-9);
      EXPECT_EQ(surface.has_flag(a, RS::Surface::CONCAVE), is_inside == (wedge < 180));
      EXPECT_EQ(surface.has_flag(a, RS::Surface::CONVEX), is_inside != (wedge < 180));
    }
  }
}

TEST(Seams_test, two_cubes_at_an_edge)
{
  // Faces in the order -x +x -y +y -z +z, cube by cube.
  const Soup soup = voxel_surface({{0, 0, 0}, {1, 1, 0}});
  const RS::Surface surface = surface_of(soup);
  EXPECT_EQ(surface.number_of_adjacencies(), 11u + 11u + 4u);
  for (std::size_t a : with_flags(surface, RS::Surface::SEAM)) {
    EXPECT_EQ(surface.length(a), 0.5);
    EXPECT_TRUE(surface.has_angle(a)) << "closed cubes are oriented alike all around";
    const bool is_of_one_cube = surface.lower_face(a) / 6 == surface.higher_face(a) / 6;
    EXPECT_EQ(surface.has_flag(a, is_of_one_cube ? RS::Surface::CONVEX : RS::Surface::CONCAVE),
              true);
  }
  // At x = y = 1: +x and +y of the first cube, -x and -y of the second.
  EXPECT_EQ(pairs_with_flags(surface, RS::Surface::SEAM), (Pairs{{1, 3}, {6, 8}, {1, 8}, {3, 6}}));
  EXPECT_EQ(with_flags(surface, RS::Surface::LINK).size(), 0u) << "seams connect, too";
  // Both are closed but for their seams: inside out they are turned.
  expect_equal_shapes(surface_of(reversed(soup)), surface);
}

TEST(Orientation_test, flipped_neighbors_are_turned)
{
  for (Family family : {Family::SPHERE, Family::SHEET, Family::BLOCKS})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      const Soup soup = triangulated(random_mesh(family, seed));
      Soup flipped = soup;
      flip_some(flipped, 3, random);
      expect_equal(surface_of(flipped), surface_of(soup));
      expect_consistent_corners(surface_of(flipped));
      // Of an open surface the larger part remains as it is.
      if (family == Family::SHEET)
        expect_equal(surface_of(reversed(flipped)), surface_of(reversed(soup)));
    }
}

/// A band of squares, closed after some half turns.
Soup band(std::size_t number, bool is_twisted)
{
  Soup soup;
  for (std::size_t i = 0; i < number; ++i) {
    const double angle = 2 * CGAL_PI * double(i) / double(number),
                 half = is_twisted ? angle / 2 : 0;
    for (double side : {-0.3, 0.3})
      soup.points.push_back({(1 + side * std::cos(half)) * std::cos(angle),
                             (1 + side * std::cos(half)) * std::sin(angle), side * std::sin(half)});
    const std::size_t a = 2 * i,
                      b = i + 1 < number ? 2 * i + 2
                          : is_twisted   ? 1
                                         : 0,
                      c = b % 2 == 0 ? b + 1 : 0;
    soup.polygons.push_back({a, b, c, a + 1});
  }
  return soup;
}

TEST(Orientation_test, a_moebius_strip_has_exactly_one_seam)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (bool is_twisted : {false, true}) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      std::mt19937 random(seed);
      const std::size_t n = 3 + seed;
      Soup soup = band(n, is_twisted);
      flip_some(soup, 2, random);
      shuffle_faces(soup, random);
      const RS::Surface surface = surface_of(soup);
      EXPECT_EQ(surface.number_of_adjacencies(), n);
      expect_consistent_corners(surface);
      const auto seams = with_flags(surface, RS::Surface::SEAM);
      ASSERT_EQ(seams.size(), is_twisted ? 1u : 0u);
      EXPECT_EQ(surface.has_seams_or_links(), is_twisted);
      if (is_twisted) {
        EXPECT_FALSE(surface.has_angle(seams[0]));
        EXPECT_NEAR(surface.length(seams[0]), 0.6, 1e-12) << "all of the edge";
      }
    }
}

TEST(Orientation_test, closed_components_inside_another_one_are_voids)
{
  // Three cubes in each other; the orientation of the outermost one says what the others are.
  const auto nested = [](bool a, bool b, bool c) {
    const Soup outer = translated(scaled(cube(), 8), -4, -4, -4),
               middle = translated(scaled(cube(), 4), -2, -2, -2),
               inner = translated(cube(), -0.5, -0.5, -0.5);
    return joined(joined(a ? reversed(outer) : outer, b ? reversed(middle) : middle),
                  c ? reversed(inner) : inner);
  };
  const auto outward = [](const RS::Surface& surface, std::size_t face) {
    return dot(surface.normal(face), surface.centroid(face)) > 0;
  };
  for (int i = 0; i < 8; ++i) {
    const bool a = i & 1, b = i & 2, c = i & 4;
    for (const RS::Surface& surface :
         {RS::make_surface(to_surface_mesh(nested(a, b, c))), surface_of(nested(a, b, c))}) {
      EXPECT_TRUE(outward(surface, 0)) << i;
      EXPECT_EQ(outward(surface, 6), a == b) << i;
      EXPECT_EQ(outward(surface, 12), a == c) << i;
      expect_consistent_corners(surface);
    }
  }
}

// As in UTM metres, and where a double has two decimals left.
TEST(Orientation_test, a_thin_wall_far_from_the_origin_keeps_its_void)
{
  const Soup outer = scaled(sphere(3), 10), inner = reversed(scaled(sphere(3), 9.9));
  for (double far : {0., 5e5, 5e6, 5e8}) {
    const Soup soup = translated(joined(outer, inner), far, -far, far / 2);
    for (const RS::Surface& surface : {RS::make_surface(to_surface_mesh(soup)), surface_of(soup)})
      for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
        const bool is_outward = dot(surface.normal(f),
                                    surface.centroid(f) - Double_3{far, -far, far / 2}) > 0;
        ASSERT_EQ(is_outward, f < outer.polygons.size()) << far << ", face " << f;
      }
  }
}

// As the quads at the poles of a sphere, of which one side has no length.
TEST(Orientation_test, sides_of_no_length_are_no_borders)
{
  const Soup closed{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}},
                    {{3, 2, 1, 0}, {0, 1, 4, 4}, {1, 2, 4, 4}, {2, 3, 4, 4}, {3, 0, 4, 4}}};
  for (const Soup& soup : {closed, reversed(closed)}) {
    const RS::Surface surface = surface_of(soup);
    EXPECT_EQ(surface.number_of_adjacencies(), 8u);
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
      EXPECT_GT(dot(surface.normal(f), surface.centroid(f) - Double_3{0.5, 0.5, 0.3}), 0) << f;
  }
}

// Two open bodies on the two sides of a pair of triangles that is given twice, with two more sides
// at one edge: not all sides can be joined to one other side.
TEST(Doubled_faces_test, beside_more_than_two_bodies_are_sewn)
{
  std::mt19937 random(1);
  Soup soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.3, 0.4, 1}, {0.4, 0.3, -1}},
            {{0, 1, 2},
             {0, 2, 3},
             {2, 1, 0},
             {3, 2, 0},
             {1, 0, 4},
             {2, 1, 4},
             {3, 2, 4},
             {0, 3, 4},
             {0, 1, 5},
             {1, 2, 5},
             {2, 3, 5},
             {3, 0, 5}}};
  for (int i = 0; i < 200; ++i) {
    Soup some = soup;
    shuffle_faces(some, random);
    some.polygons.resize(6 + random() % 7);
    for (const RS::Surface& surface : {surface_of(some), surface_of(torn(some))}) {
      expect_consistent_corners(surface);
      for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
        for (std::size_t side = 0; side < surface.number_of_corners(f); ++side)
          if (const auto a = surface.adjacency(f, side); a != RS::Surface::none) {
            EXPECT_TRUE(surface.lower_face(a) == f || surface.higher_face(a) == f);
          }
    }
  }
}

// Every triangle has points of its own, whose coordinates are moved by up to `amplitude` of the
// largest coordinate.
Soup torn_apart(const Soup& soup, double amplitude, std::mt19937& random)
{
  double largest = 0;
  Soup result = torn(soup);
  for (const Point& p : result.points)
    for (double x : p)
      largest = std::max(largest, std::abs(x));
  for (Point& p : result.points)
    for (double& x : p)
      x += largest * std::uniform_real_distribution<>(-amplitude, amplitude)(random);
  return result;
}

TEST(Points_apart_by_rounding_test, are_one)
{
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (double far : {0., 100., -3000.}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(far));
      std::mt19937 random(seed);
      const Soup soup = translated(triangulated(dumbbell()), far, far, 0);
      const RS::Surface whole = surface_of(soup);
      const RS::Surface surface = surface_of(torn_apart(soup, 0x1p-24, random));
      EXPECT_EQ(surface.number_of_adjacencies(), whole.number_of_adjacencies());
      EXPECT_EQ(surface.number_of_components(), 1u);
      EXPECT_EQ(surface.number_of_vertices_apart_by_rounding(),
                surface.number_of_vertices() - soup.points.size());
      EXPECT_EQ(whole.number_of_vertices_apart_by_rounding(), 0u);
      // As borders of a face graph.
      const RS::Surface of_graph = RS::make_surface(
        to_surface_mesh(torn_apart(soup, 0x1p-24, random)));
      EXPECT_EQ(of_graph.number_of_adjacencies(), whole.number_of_adjacencies());
    }
}

TEST(Points_apart_by_rounding_test, those_farther_apart_stay)
{
  // A slit of 2^-20 of the size, and one that is as wide as the sides beside it are long.
  for (double width : {0x1p-20, 0.5}) {
    const double far = width < 0.1 ? 1 : 0x1p22;
    Soup soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}};
    soup = joined(translated(soup, far - 1, 0, 0), translated(soup, far - 1, -1 - width, 0));
    const RS::Surface surface = surface_of(soup);
    EXPECT_EQ(surface.number_of_components(), 2u) << width;
    EXPECT_EQ(surface.number_of_vertices_apart_by_rounding(), 0u) << width;
  }
}

// Polygons whose area vector is parallel to an edge of four faces have no direction around it.
TEST(Seams_test, faces_without_a_direction_around_their_edge_are_sewn)
{
  Soup soup{{{0, 0, 0}, {0, 0, 1}}, {}};
  for (int i = 0; i < 40; ++i) { // a zigzag whose area vector is (0, 0, 1) or about
    const double x = 1 + i % 7, y = i % 5;
    const std::size_t n = soup.points.size();
    soup.points.insert(soup.points.end(),
                       {{x, y, 1}, {-x, 2 * y + 1, 0}, {x, 2, 0}, {x - 3, y, 0}});
    soup.polygons.push_back({0, 1, n, n + 1, n + 2, n + 3});
  }
  // A square and its path back: Newell's vector of 0 1 ... is along the edge 0 1.
  const std::size_t n = soup.points.size();
  soup.points.insert(soup.points.end(), {{1, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  for (int i = 0; i < 20; ++i)
    soup.polygons.push_back({0, 1, n, n + 1, n + 2, n + 3, 0, n + 1, n, 1});
  const RS::Surface surface = surface_of(soup);
  EXPECT_EQ(surface.number_of_faces(), 60u);
  expect_consistent_corners(surface);
}

// Two boxes with a side of each on the same points: with points of each body, with common points,
// and with those of each triangle.
TEST(Doubled_faces_test, of_two_bodies_remain)
{
  const Soup two = joined(cube(), translated(cube(), 0, 0, 1));
  Soup shared = two;
  for (Polygon& polygon : shared.polygons)
    for (std::size_t& v : polygon)
      v = std::size_t(std::find(two.points.begin(), two.points.end(), two.points[v]) -
                      two.points.begin());
  for (const Soup& soup : {two, shared, triangulated(shared), torn(triangulated(shared))}) {
    const RS::Surface surface = surface_of(soup);
    EXPECT_EQ(surface.number_of_components(), 2u);
    EXPECT_EQ(surface.area(), 12);
    EXPECT_TRUE(with_flags(surface, RS::Surface::SEAM).empty());
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      EXPECT_FALSE(surface.is_degenerate(f));
      const double middle = f < surface.number_of_faces() / 2 ? 0.5 : 1.5;
      EXPECT_GT(dot(surface.normal(f), surface.centroid(f) - Double_3{0.5, 0.5, middle}), 0);
    }
    expect_consistent_corners(surface);
  }
  // A face of one body that is given twice is still degenerate.
  Soup twice = shared;
  twice.polygons.push_back(shared.polygons[5]);
  EXPECT_TRUE(surface_of(twice).is_degenerate(12));
}

TEST(Doubled_faces_test, are_degenerate_and_adjacent_to_the_first_alone)
{
  const auto families = {Family::SHEET, Family::SPHERE, Family::TORUS, Family::QUAD_SHEET};
  for_each_random_mesh(families, 4, [&](const Soup& soup, unsigned seed) {
    std::mt19937 random(seed);
    const std::size_t n = soup.polygons.size();
    Soup doubled = soup;
    std::vector<std::size_t> original;
    for (int i = 0; i < 20; ++i) { // some three times
      original.push_back(random() % (n / 4));
      Polygon polygon = soup.polygons[original.back()];
      std::rotate(polygon.begin(), polygon.begin() + random() % polygon.size(), polygon.end());
      if (random() % 2 == 0)
        std::reverse(polygon.begin(), polygon.end());
      doubled.polygons.push_back(polygon);
    }
    const RS::Surface expected = surface_of(soup), surface = surface_of(doubled);
    EXPECT_EQ(surface.area(), expected.area());
    ASSERT_EQ(surface.number_of_adjacencies(), expected.number_of_adjacencies() + original.size());
    for (std::size_t f = 0; f < n; ++f) {
      EXPECT_TRUE(is_equal(surface.normal(f), expected.normal(f)));
      EXPECT_EQ(corners_of(surface, f), corners_of(expected, f));
    }
    for (std::size_t i = 0; i < original.size(); ++i) {
      const std::size_t a = expected.number_of_adjacencies() + i;
      EXPECT_TRUE(surface.is_degenerate(n + i));
      EXPECT_EQ(surface.area(n + i), 0);
      EXPECT_EQ(surface.higher_face(a), n + i);
      EXPECT_EQ(surface.lower_face(a), original[i]);
      EXPECT_EQ(surface.flags(a), RS::Surface::JOINING);
    }
  });
}

// In a face graph, too, where a neighbor of the copy is adjacent to the first one then.
TEST(Doubled_faces_test, of_a_face_graph_are_as_of_polygons)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const auto surface_with = [&](const std::vector<int>& order) {
    Surface_mesh mesh;
    std::vector<Surface_mesh::Vertex_index> v;
    for (const std::size_t p : {0, 1, 2, 0, 1, 2, 3})
      v.push_back(mesh.add_vertex(Kernel::Point_3(points[p][0], points[p][1], points[p][2])));
    for (const int face : order)
      if (face == 0)
        mesh.add_face(v[0], v[1], v[2]);
      else if (face == 1)
        mesh.add_face(v[3], v[4], v[5]); // equal
      else
        mesh.add_face(v[5], v[4], v[6]); // beside it
    return RS::make_surface(mesh);
  };
  for (const std::vector<int>& order : {std::vector<int>{0, 1, 2}, {0, 2, 1}, {2, 0, 1}}) {
    Soup soup{points, {}};
    for (const int face : order)
      soup.polygons.push_back(face == 2 ? Polygon{2, 1, 3} : Polygon{0, 1, 2});
    const RS::Surface surface = surface_with(order), expected = surface_of(soup);
    ASSERT_EQ(surface.number_of_adjacencies(), 2u);
    EXPECT_EQ(adjacencies_of(surface), adjacencies_of(expected));
  }
}

TEST(Doubled_faces_test, polygons_with_the_same_corners_in_another_order_are_others)
{
  const Soup soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}},
                  {{0, 1, 2, 3}, {0, 1, 3, 2}, {2, 3, 1, 0}, {3, 2, 1, 0}}};
  const RS::Surface surface = surface_of(soup);
  EXPECT_FALSE(surface.is_degenerate(0));
  EXPECT_FALSE(surface.is_degenerate(1));
  EXPECT_TRUE(surface.is_degenerate(2)) << "the second, reversed";
  EXPECT_TRUE(surface.is_degenerate(3)) << "the first, reversed";
  EXPECT_EQ(surface.lower_face(surface.first_adjacency(2)), 1u);
  EXPECT_EQ(surface.lower_face(surface.first_adjacency(3)), 0u);
}

// If their keys were equal, this would take minutes.
TEST(Doubled_faces_test, thousands_with_the_same_corners_are_told_apart_in_time)
{
  Soup soup;
  std::mt19937 random(1);
  for (int i = 0; i < 10; ++i)
    soup.points.push_back({double(random() % 1000), double(random() % 1000), double(i)});
  Polygon polygon(10);
  std::iota(polygon.begin(), polygon.end(), std::size_t(0));
  std::set<Polygon> different;
  while (different.size() < 100000) {
    std::shuffle(polygon.begin() + 1, polygon.end(), random);
    if (polygon[1] < polygon.back())
      different.insert(polygon);
  }
  soup.polygons.assign(different.begin(), different.end());
  const RS::Surface surface = RS::make_surface_of_polygon_soup(
    soup.points, soup.polygons, RS::parameters::component_links(false));
  std::size_t degenerate = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    degenerate += surface.is_degenerate(f);
  EXPECT_EQ(degenerate, 0u);
}

TEST(Degenerate_polygons_test, join_across_their_longest_edge)
{
  // Two triangles with a common edge, on which lie a polygon of two corners, and a triangle without
  // area.
  const Soup soup{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}, {0.5, 0, 0}},
                  {{0, 1, 2}, {1, 0, 3}, {0, 1}, {0, 4, 1}, {2, 2, 0}, {3}}};
  const RS::Surface surface = surface_of(soup);
  for (std::size_t f : {2, 3, 4, 5})
    EXPECT_TRUE(surface.is_degenerate(f)) << f;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<int>> flags;
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    flags[{surface.lower_face(a), surface.higher_face(a)}].push_back(surface.flags(a));
  EXPECT_EQ((flags[{0, 1}]), std::vector<int>{0})
    << "an edge, and flat: degenerate faces do not make it a seam";
  EXPECT_EQ((std::count(flags[{0, 2}].begin(), flags[{0, 2}].end(), int(RS::Surface::JOINING))), 1);
  EXPECT_EQ((flags[{0, 3}]), std::vector<int>{RS::Surface::JOINING});
  EXPECT_EQ((std::count(flags[{0, 4}].begin(), flags[{0, 4}].end(), int(RS::Surface::JOINING))), 1);
  EXPECT_EQ(with_flags(surface, RS::Surface::SEAM).size(), 0u);
  EXPECT_EQ(surface.area(), 2);
}

TEST(Coinciding_borders_test, of_a_face_graph_are_adjacent)
{
  // Two sheets side by side with points of their own, in one mesh.
  const Soup soup = joined(grid(3, 4), translated(grid(2, 4), 3, 0, 0)), whole = grid(5, 4);
  const Surface_mesh mesh = to_surface_mesh(soup);
  const RS::Surface apart = RS::make_surface(mesh, RS::parameters::component_links(false));
  const RS::Surface surface = RS::make_surface(mesh);
  EXPECT_EQ(apart.number_of_adjacencies(), 17u + 10u);
  EXPECT_EQ(surface.number_of_adjacencies(), 17u + 10u + 4u);
  EXPECT_EQ(surface_of(whole).number_of_adjacencies(), 31u);
  EXPECT_FALSE(surface.has_seams_or_links());
  for (std::size_t y = 0; y < 4; ++y) { // squares 3 y + 2 and 12 + 2 y
    const std::size_t a = surface.first_adjacency(12 + 2 * y);
    EXPECT_EQ(surface.lower_face(a), 3 * y + 2);
    EXPECT_EQ(surface.higher_face(a), 12 + 2 * y);
    EXPECT_EQ(surface.length(a), 1);
    EXPECT_TRUE(surface.has_angle(a));
  }
  // In a soup always.
  EXPECT_EQ(RS::make_surface_of_polygon_soup(soup.points, soup.polygons,
                                             RS::parameters::component_links(false))
              .number_of_adjacencies(),
            31u);
  EXPECT_EQ(surface_of(soup).number_of_adjacencies(), 31u);
}

// Two sheets of paper along two edges of equal length: of a polygon soup and of a face graph.
TEST(Constraints_test, bar_the_edge_that_they_name_and_no_other_of_its_faces)
{
  const Soup soup = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                     {{0, 1, 2, 3}, {1, 4, 5, 6, 3, 2}}};
  const Surface_mesh mesh = to_surface_mesh(soup);
  const RS::Surface of_mesh = RS::make_surface(mesh,
                                               RS::parameters::edge_is_constrained_map(
                                                 edge_map(mesh, std::set<Edge>{make_edge(1, 2)}))),
                    of_polygons = RS::make_surface_of_polygon_soup(
                      soup.points, soup.polygons,
                      RS::parameters::constrained_edges(std::vector<std::pair<int, int>>{{2, 1}}));
  for (const RS::Surface* surface : {&of_mesh, &of_polygons}) {
    ASSERT_EQ(surface->number_of_adjacencies(), 2u);
    EXPECT_EQ(surface->squared_length(0), surface->squared_length(1));
    const std::size_t across_1_2 = surface->adjacency(0, 1), across_2_3 = surface->adjacency(0, 2);
    EXPECT_TRUE(surface->has_flag(across_1_2, RS::Surface::CONSTRAINED));
    EXPECT_FALSE(surface->has_flag(across_2_3, RS::Surface::CONSTRAINED));
  }
}

TEST(Coinciding_borders_test, are_constrained_with_one_of_them)
{
  const Soup soup = joined(grid(3, 4), translated(grid(2, 4), 3, 0, 0));
  const Surface_mesh mesh = to_surface_mesh(soup);
  // Of the first sheet at x = 3, from y = 1 to 2; of the second one from y = 2 to 3.
  const std::set<Edge> constrained = {make_edge(4 + 3, 8 + 3), make_edge(20 + 6, 20 + 9)};
  const RS::Surface surface = RS::make_surface(
    mesh, RS::parameters::edge_is_constrained_map(edge_map(mesh, constrained)));
  EXPECT_EQ(pairs_with_flags(surface, RS::Surface::CONSTRAINED), (Pairs{{5, 14}, {8, 16}}));
}

} // namespace Surface_test
