// SPDX-License-Identifier: GPL-3.0-or-later

// Faces of tessellated shapes that are made by formula, with their surfaces.

#include "meshes.h"
#include "oracles.h"
#include "shapes_with_faces.h"

#include <CGAL/Region_segmentation/Part_faces/find_part_faces.h>
#include <CGAL/Region_segmentation/Part_faces/find_surface_faces.h>

#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>

#include <CGAL/Region_segmentation/Part_faces/find_common_surfaces.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <CGAL/Bbox_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace find_surface_faces_test {

namespace RS = CGAL::Region_segmentation;
using namespace shapes_with_faces;
using RS::Face_role;
using RS::Surface_kind;
using shapes_with_faces::Point;

RS::Surface surface_of(const Shape& shape)
{
  const test::Soup soup = soup_of(shape);
  return RS::make_surface_of_polygon_soup(soup.points, soup.polygons);
}

/// Expects the faces of the shape, and returns their surfaces, in the order of the faces.
std::vector<RS::Fitted_surface<>> expect_faces(const Shape& shape)
{
  const RS::Surface_faces found = RS::find_surface_faces(surface_of(shape));
  EXPECT_EQ(found.partition, RS::Partition::from_labels(shape.faces));
  EXPECT_EQ(found.surfaces.size(), std::size_t(shape.number_of_faces));
  for (const RS::Fitted_surface<>& s : found.surfaces)
    EXPECT_TRUE(found.tolerance > 1e-5 || s.deviation <= found.tolerance);
  std::vector<RS::Fitted_surface<>> result(shape.number_of_faces);
  for (std::size_t f = 0; f < shape.faces.size(); ++f)
    result[shape.faces[f]] = found.surfaces[found.partition[f]];
  return result;
}

/// What is expected of a surface: 0 is any size or side.
struct Expected
{
  Surface_kind kind;
  double radius = 0, minor_radius = 0;
  int side = 0;
  double angle = 0;
};
const Expected plane{Surface_kind::PLANE}, freeform{Surface_kind::FREEFORM};

Expected cylinder(double radius = 0, int side = 0)
{
  return {Surface_kind::CYLINDER, radius, 0, side};
}

Expected cone(double degrees)
{
  return {Surface_kind::CONE, 0, 0, 0, degrees * pi / 180};
}

/// Expects the faces of the shape, the first of them on such surfaces.
void expect_surfaces(const Shape& shape, const std::vector<Expected>& expected)
{
  const std::vector<RS::Fitted_surface<>> found = expect_faces(shape);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    SCOPED_TRACE(testing::Message() << "face " << i);
    const bool is_round = found[i].minor_radius == 0 && found[i].angle == 0;
    const auto expect_size = [&](double size, double wanted) {
      if (wanted > 0) {
        EXPECT_NEAR(size, wanted, is_round ? 5e-8 * wanted : 1e-6);
      }
    };
    EXPECT_EQ(found[i].kind, expected[i].kind);
    expect_size(found[i].radius, expected[i].radius);
    expect_size(found[i].minor_radius, expected[i].minor_radius);
    expect_size(found[i].angle, expected[i].angle);
    EXPECT_TRUE(expected[i].side == 0 || found[i].side == expected[i].side);
  }
}

TEST(FindSurfaceFaces, Box)
{
  for (const int n : {1, 4})
    expect_surfaces(box(1, 2, 3, n), std::vector<Expected>(6, plane));
  for (const double height : {1e-3, 2e-4}) // narrow triangles have normals, too
    expect_surfaces(box(1, 2, height, 1), std::vector<Expected>(6, plane));
}

TEST(FindSurfaceFaces, CylinderWithHole)
{
  for (const int turns : {12, 40})
    for (const int rows : {1, 3}) {
      const Shape shape = ring(2, 2, 1, 3, turns, rows);
      expect_surfaces(shape, {cylinder(2, 1), cylinder(1, -1), plane, plane});
      EXPECT_NEAR(std::fabs(expect_faces(shape)[1].direction.z), 1, 1e-12);
    }
}

TEST(FindSurfaceFaces, SphereAndTorus)
{
  expect_surfaces(dome(2, 24, 7), {{Surface_kind::SPHERE, 2}, plane});
  expect_surfaces(torus(3, 1, 40, 16), {{Surface_kind::TORUS, 3, 1}});
}

// Planes and fillets meet smoothly, also those of large radius: their surfaces tell them apart.
TEST(FindSurfaceFaces, Fillets)
{
  for (const int facets : {3, 6})
    for (const int rows : {1, 5})
      expect_surfaces(filleted_bar(3, 1, 5, facets, rows),
                      {plane, cylinder(1), plane, cylinder(1), plane, cylinder(1), plane,
                       cylinder(1), plane, plane});
  expect_surfaces(filleted_bar(1, 20, 5, 30, 8), {plane, cylinder(20)});
}

// A shaft with a flat, whose vertices lie on the cylinder: it deviates more than its facets do.
TEST(FindSurfaceFaces, ShaftWithFlat)
{
  constexpr double first = 1.0 / 18, last = 17.0 / 18; // turns
  const auto section = [](double u) { return first + (last - first) * u; };
  const auto cap = [&](Shape& shape, double z, bool is_top) {
    shape.add_face(
      40, 1, [&](double u, double v) { return around(2 * (is_top ? 1 - v : v), section(u), z); });
    const Point ends[] = {around(2, first, z), around(2, last, z)};
    shape.add_triangle(ends[is_top ? 1 : 0], ends[is_top ? 0 : 1], {0, 0, z},
                       shape.number_of_faces - 1);
  };
  Shape shape;
  shape.add_face(40, 1, [&](double u, double v) { return around(2, section(u), 3 * v); });
  shape.add_face(1, 1, [&](double u, double v) {
    return (1 - u) * around(2, last, 3 * v) + u * around(2, first, 3 * v);
  });
  cap(shape, 0, false);
  cap(shape, 3, true);
  expect_surfaces(shape, {cylinder(2), plane, plane, plane});
}

/// A solid between two planes: `radius(turns, z)` is that of its wall, of rows by the angle
/// and the height.
template <typename Function>
Shape with_wall(int turns, int rows, const Function& radius)
{
  const auto at = [&](double along, double turn, double z) {
    return around(along * radius(turn, z), turn, z);
  };
  Shape shape;
  shape.add_face(turns, rows, [&](double u, double v) { return at(1, u, 3 * v); });
  shape.add_face(turns, 2, [&](double u, double v) { return at(v, u, 0); });
  shape.add_face(turns, 2, [&](double u, double v) { return at(1 - v, u, 3); });
  return shape;
}

// Two rows of facets of an extruded curve lie on a cylinder, one row of a revolved one on a cone;
// cylinders, cones and tori osculate others.
TEST(FindSurfaceFaces, FreeformWalls)
{
  const auto cam = [](double turn, double) { return 2 + 0.3 * std::cos(4 * pi * turn); };
  const auto both = [](double turn, double z) {
    return 2 + 0.3 * std::sin(z) + 0.2 * std::cos(4 * pi * turn);
  };
  for (const Shape& shape : {with_wall(40, 1, cam), with_wall(64, 1, cam), with_wall(32, 6, both),
                             with_wall(64, 24, both)}) {
    SCOPED_TRACE(shape.triangles.size());
    expect_surfaces(shape, {freeform, plane, plane});
  }
}

/// A plate with rounded corners of `facets` facets and a chamfer of one row around its top: of each
/// side and each corner the wall and the chamfer, then top and bottom.
Shape chamfered_plate(int facets)
{
  constexpr double chamfer = 0.1;
  const auto corner = [](int k, double turns, double inwards, double z) {
    const double x[] = {3, -3, -3, 3}, y[] = {2, 2, -2, -2};
    return Point{x[k % 4], y[k % 4], 0} + around(1 - inwards, (k % 4 + turns) / 4, z);
  };
  Shape shape;
  for (int k = 0; k < 4; ++k) {
    const auto side = [&](double u, double inwards, double z) {
      return (1 - u) * corner(k, 1, inwards, z) + u * corner(k + 1, 0, inwards, z);
    };
    shape.add_face(1, 1, [&](double u, double v) { return side(u, 0, v); });
    shape.add_face(1, 1, [&](double u, double v) { return side(u, v * chamfer, 1 + v * chamfer); });
    shape.add_face(facets, 1, [&](double u, double v) { return corner(k, u, 0, v); });
    shape.add_face(facets, 1,
                   [&](double u, double v) { return corner(k, u, v * chamfer, 1 + v * chamfer); });
  }
  const int around_all = 4 * (facets + 1);
  const auto outline = [&](int i, double inwards, double z) {
    return corner(i / (facets + 1), double(i % (facets + 1)) / facets, inwards, z);
  };
  for (int i = 0; i < around_all; ++i) {
    const int next = (i + 1) % around_all;
    shape.add_triangle(outline(i, chamfer, 1 + chamfer), outline(next, chamfer, 1 + chamfer),
                       {0, 0, 1 + chamfer}, shape.number_of_faces);
    shape.add_triangle(outline(next, 0, 0), outline(i, 0, 0), {0, 0, 0}, shape.number_of_faces + 1);
  }
  shape.number_of_faces += 2;
  return shape;
}

// One row of facets between sharp edges is a face, also where it goes on smoothly at its ends. (Two
// circles lie on a sphere, too, so the kind of the rounded ones is not tested.)
TEST(FindSurfaceFaces, ChamferOfOneRow)
{
  for (const int facets : {5, 7, 12}) {
    SCOPED_TRACE(facets);
    const std::vector<RS::Fitted_surface<>> s = expect_faces(chamfered_plate(facets));
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(s[4 * k].kind, Surface_kind::PLANE);
      EXPECT_EQ(s[4 * k + 1].kind, Surface_kind::PLANE);
      EXPECT_EQ(s[4 * k + 2].kind, Surface_kind::CYLINDER);
    }
  }
}

// The three circles of this shaft and its chamfer are on a sphere, too.
TEST(FindSurfaceFaces, ChamferOfShaft)
{
  for (const int turns : {12, 24, 48}) {
    SCOPED_TRACE(turns);
    const std::vector<RS::Fitted_surface<>> s = expect_faces(
      revolved({{0, 0}, {3, 0}, {3, 5}, {2.5, 5.5}, {0, 5.5}}, turns));
    EXPECT_EQ(s[1].kind, Surface_kind::CYLINDER);
    EXPECT_EQ(s[2].kind, Surface_kind::CONE);
  }
}

/// A tube of radius 0.4 around a helix of radius 2 that rises by `pitch` per radian, with its ends.
Shape helical_tube(double pitch, double radians)
{
  const double slant = std::hypot(2, pitch);
  const auto at = [&](double along, double turns, double radius) {
    const double t = radians * along, c = std::cos(t), s = std::sin(t);
    const Point outward{c, s, 0}, up{pitch / slant * s, -pitch / slant * c, 2 / slant};
    return Point{2 * c, 2 * s, pitch * t} + (radius * std::cos(2 * pi * turns)) * outward +
           (radius * std::sin(2 * pi * turns)) * up;
  };
  Shape shape;
  shape.add_face(24, 80, [&](double u, double v) { return at(v, -u, 0.4); });
  shape.add_face(24, 3, [&](double u, double v) { return at(0, u, 0.4 * v); });
  shape.add_face(24, 3, [&](double u, double v) { return at(1, -u, 0.4 * v); });
  return shape;
}

// Tori osculate a tube along a curve; most of it is one face.
TEST(FindSurfaceFaces, HelicalTube)
{
  for (const double pitch : {0.1, 0.3})
    for (const double radians : {4.0, 12.0}) {
      const Shape shape = helical_tube(pitch, radians);
      const RS::Surface surface = surface_of(shape);
      const RS::Surface_faces found = RS::find_surface_faces(surface);
      double tube = 0;
      std::vector<double> areas(found.surfaces.size(), 0);
      for (std::size_t f = 0; f < shape.faces.size(); ++f)
        if (shape.faces[f] == 0) {
          tube += surface.area(f);
          areas[found.partition[f]] += surface.area(f);
        }
      const auto largest = std::max_element(areas.begin(), areas.end());
      EXPECT_GT(*largest, 0.9 * tube) << pitch << " " << radians;
      EXPECT_EQ(found.surfaces[largest - areas.begin()].kind, Surface_kind::FREEFORM);
    }
  EXPECT_EQ(expect_faces(helical_tube(0, 4))[0].kind, Surface_kind::TORUS);
}

/// A cylinder of 24 facets of which the vertices were moved along the facets, as by remeshing: it
/// has `columns` of them, and an even number of rows, every other one shifted. Wall, bottom, top.
Shape with_remeshed_wall(int columns, int rows)
{
  const auto at = [](double along, double turn, double z) {
    const double facet = 2 * pi / 24, angle = std::fmod(2 * pi * turn + 0.02, facet) - facet / 2;
    return around(along * 2 * std::cos(facet / 2) / std::cos(angle), turn, z);
  };
  Shape shape;
  shape.add_face(columns, rows, [&](double u, double v) {
    const double shift = std::lround(v * rows) % 2 * 0.5 / columns;
    return at(1, u + shift, 3 * v);
  });
  shape.add_face(columns, 2, [&](double u, double v) { return at(v, u, 0); });
  shape.add_face(columns, 2, [&](double u, double v) { return at(1 - v, u, 3); });
  return shape;
}

// The tolerance is five standard deviations: of exact, rounded, noisy coordinates, and of those of
// an assembly, far from the origin in single precision.
TEST(FindSurfaceFaces, Tolerance)
{
  const auto deviation = [&](const Shape& shape) {
    return RS::find_surface_faces(surface_of(shape)).tolerance / 5;
  };
  const Shape ring = helical_tube(0, 4);
  CGAL::Bbox_3 box;
  for (const Point& p : ring.points)
    box += CGAL::Bbox_3(p.x, p.y, p.z, p.x, p.y, p.z);
  const double size = std::hypot(box.x_span(), box.y_span(), box.z_span());
  EXPECT_NEAR(deviation(ring), 2e-7 * size, 1e-9 * size);
  const auto moved = [&](const auto& move) {
    Shape shape = ring;
    for (Point& p : shape.points)
      p = Point{move(p.x), move(p.y), move(p.z)};
    return shape;
  };
  const unsigned seed = 5;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 1);
  for (const double sigma : {1e-6, 1e-5, 1e-4, 2e-3}) {
    SCOPED_TRACE(sigma);
    const Shape noisy = moved([&](double x) { return x + sigma * noise(random); });
    EXPECT_GT(deviation(noisy), 0.7 * (std::max)(sigma, 2e-7 * size));
    EXPECT_LT(deviation(noisy), 1.4 * (std::max)(sigma, 2e-7 * size));
    EXPECT_EQ(expect_faces(noisy)[0].kind, Surface_kind::TORUS);
  }
  const Shape rounded = moved([](double x) { return std::round(x * 1e4) / 1e4; });
  EXPECT_NEAR(deviation(rounded), 0.35e-4, 1e-8);
  EXPECT_EQ(expect_faces(rounded)[0].kind, Surface_kind::TORUS);
  const Shape far = moved([](double x) { return double(float(x + 1000)); });
  EXPECT_NEAR(deviation(far), 0.35 * 2 * 1000 * std::numeric_limits<float>::epsilon(), 1e-6);
  EXPECT_EQ(expect_faces(far)[0].kind, Surface_kind::TORUS);
}

// Vertices that remeshing has moved along facets are on their surface within the sagitta of these.
TEST(FindSurfaceFaces, ToleranceOfRemeshing)
{
  const Shape remeshed = with_remeshed_wall(40, 12);
  const double sagitta = 2 * (1 - std::cos(pi / 24));
  const RS::Surface_faces found = RS::find_surface_faces(surface_of(remeshed), sagitta);
  EXPECT_EQ(found.tolerance, sagitta);
  EXPECT_EQ(found.partition, RS::Partition::from_labels(remeshed.faces));
  EXPECT_EQ(found.surfaces[0].kind, Surface_kind::CYLINDER);
  EXPECT_NEAR(found.surfaces[0].radius, 2, sagitta);
}

// Noise between the rounding of exact and of few digits, and a freeform surface of small facets:
// ten times the tolerance for rounding would cover both with many faces.
TEST(FindSurfaceFaces, ToleranceOfSmallDeviations)
{
  const unsigned seed = 6;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const double deviation : {3e-6, 5e-6, 7e-6}) {
    SCOPED_TRACE(deviation);
    std::normal_distribution<double> noise(0, deviation);
    Shape plate;
    plate.add_face(60, 60, [](double u, double v) { return Point{u, v, 0}; });
    for (Point& p : plate.points)
      p.z = noise(random);
    expect_faces(plate);
  }
  const auto wave = [](double u, double v) {
    return Point{u, v, 0.05 * std::sin(5 * u) * std::cos(3 * v + 2 * u)};
  };
  for (const int n : {60, 120}) { // places of the finer one lie on surfaces to rounding
    Shape freeform;
    freeform.add_face(n, n, wave);
    EXPECT_LE(RS::find_surface_faces(surface_of(freeform)).surfaces.size(), n == 60 ? 1u : 10u);
  }
}

Profile line(double r, double z, double next_r, double next_z, int rows = 1)
{
  Profile profile;
  for (int i = 0; i <= rows; ++i) {
    const double t = double(i) / rows;
    profile.push_back({r + t * (next_r - r), z + t * (next_z - z)});
  }
  return profile;
}

// Cones of one and more rows of facets, whatever their fineness, flat and steep.
TEST(FindSurfaceFaces, Frusta)
{
  for (const int rows : {1, 2, 3, 8})
    for (const int turns : {12, 32, 128})
      for (const double degrees : {8.0, 45.0, 78.0}) {
        SCOPED_TRACE(testing::Message() << rows << ' ' << turns << ' ' << degrees);
        const double height = 1 / std::tan(degrees * pi / 180);
        expect_surfaces(
          revolved_faces(
            {line(0, 0, 2, 0), line(2, 0, 1, height, rows), line(1, height, 0, height)}, turns),
          {plane, cone(degrees), plane});
      }
}

// Chamfers and countersinks: two circles lie on a sphere, three on a torus, too.
TEST(FindSurfaceFaces, Chamfers)
{
  for (const int turns : {12, 24, 48, 128})
    for (const double degrees : {20.0, 45.0, 70.0})
      for (const double width : {0.02, 0.5}) {
        SCOPED_TRACE(testing::Message() << turns << ' ' << degrees << ' ' << width);
        const double height = width / std::tan(degrees * pi / 180);
        expect_surfaces(
          revolved_faces({line(0, 0, 3, 0), line(3, 0, 3, 5), line(3, 5, 3 - width, 5 + height),
                          line(3 - width, 5 + height, 0, 5 + height)},
                         turns),
          {plane, cylinder(3), cone(degrees), plane});
      }
}

// A boss on a disk, with a fillet at its foot: of 2 rows, since it is tangent to both.
TEST(FindSurfaceFaces, FilletsOfBosses)
{
  for (const int steps : {2, 3, 4, 12})
    for (const int turns : {16, 48}) {
      SCOPED_TRACE(testing::Message() << steps << ' ' << turns);
      Profile fillet;
      for (int i = 0; i <= steps; ++i) {
        const double angle = pi / 2 * i / steps;
        fillet.push_back({1.8 - 0.3 * std::sin(angle), 1.3 - 0.3 * std::cos(angle)});
      }
      expect_surfaces(
        revolved_faces({line(0, 0, 3, 0), line(3, 0, 3, 1), line(3, 1, 1.8, 1), fillet,
                        line(1.5, 1.3, 1.5, 4), line(1.5, 4, 0, 4)},
                       turns),
        {plane, cylinder(3), plane, {Surface_kind::TORUS, 1.8, 0.3, -1}, cylinder(1.5), plane});
    }
}

/// Splits a triangle and its neighbor across one of its edges at a point of it.
void split_edge(Shape& shape, std::size_t triangle, int side, const Point& p)
{
  const std::uint32_t a = shape.triangles[triangle][std::size_t(side)],
                      b = shape.triangles[triangle][std::size_t((side + 1) % 3)],
                      m = std::uint32_t(shape.points.size());
  shape.points.push_back(p);
  for (std::size_t t = 0, n = shape.triangles.size(); t < n; ++t) {
    auto& corners = shape.triangles[t];
    if (std::count(corners.begin(), corners.end(), a) &&
        std::count(corners.begin(), corners.end(), b)) {
      auto other = corners;
      std::replace(corners.begin(), corners.end(), b, m);
      std::replace(other.begin(), other.end(), a, m);
      shape.triangles.push_back(other);
      shape.faces.push_back(shape.faces[t]);
    }
  }
}

// Needles, and triangles without area that fill T-vertices: creases beside them are borders.
TEST(FindSurfaceFaces, SliversHaveNoVote)
{
  const unsigned seed = 51;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    Shape shape = i % 2 ? box(1, 1, 1, 1) : ring(2, 2, 1, 3, 24, 1);
    // A flat face: a vertex on an edge of a curved one would not be on its surface.
    std::size_t triangle = 0;
    do
      triangle = random() % shape.triangles.size();
    while (!(i % 2) && shape.faces[triangle] < 2);
    const int side = int(random() % 3);
    const Point &p = shape.points[shape.triangles[triangle][std::size_t(side)]],
                &q = shape.points[shape.triangles[triangle][std::size_t((side + 1) % 3)]];
    const double t = i % 3 ? 0.5 : std::pow(10.0, -3 - double(random() % 4));
    const Point middle{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)};
    std::size_t without_area = shape.triangles.size();
    if (i % 3) { // only the one triangle is split, and what is between is filled
      const auto corners = shape.triangles[triangle];
      const std::uint32_t a = corners[std::size_t(side)], b = corners[std::size_t((side + 1) % 3)],
                          c = corners[std::size_t((side + 2) % 3)],
                          m = std::uint32_t(shape.points.size());
      shape.points.push_back(middle);
      shape.triangles[triangle] = {a, m, c};
      shape.triangles.push_back({m, b, c});
      shape.faces.push_back(shape.faces[triangle]);
      without_area = shape.triangles.size();
      shape.triangles.push_back({a, b, m});
      shape.faces.push_back(shape.faces[triangle]);
    } else if (i % 2)
      split_edge(shape, triangle, side, middle);
    RS::Surface_faces found = RS::find_surface_faces(surface_of(shape));
    ASSERT_EQ(found.surfaces.size(), std::size_t(shape.number_of_faces));
    std::vector<int> face_of(found.surfaces.size(), -1);
    for (std::size_t f = 0; f < shape.triangles.size(); ++f)
      if (f != without_area) {
        int& face = face_of[found.partition[f]];
        EXPECT_TRUE(face == -1 || face == shape.faces[f]);
        face = shape.faces[f];
      }
  }
}

// Nothing grows across an edge of three faces: a box with a wall inside is eleven squares.
TEST(FindSurfaceFaces, EdgesOfThreeFaces)
{
  test::Soup two = test::joined(test::cube(), test::translated(test::cube(), 1, 0, 0));
  two.polygons.erase(two.polygons.begin() + 6); // the wall is there once
  const RS::Surface_faces found = RS::find_surface_faces(
    RS::make_surface_of_polygon_soup(two.points, two.polygons));
  EXPECT_EQ(found.surfaces.size(), two.polygons.size());
  for (const RS::Fitted_surface<>& s : found.surfaces)
    EXPECT_EQ(s.kind, Surface_kind::PLANE);
}

// Coordinates of 3 to 6 decimals, of a turned part, near the origin and far from it.
TEST(FindSurfaceFaces, FewDecimals)
{
  for (const int decimals : {3, 4, 6})
    for (const double offset : {0.0, 5411932.0}) {
      SCOPED_TRACE(testing::Message() << decimals << ' ' << offset);
      const double unit = std::pow(10.0, decimals), c = std::cos(0.7), s = std::sin(0.7);
      Shape shape = box(2, 3, 4, 4);
      for (Point& p : shape.points) {
        const Point turned{c * p.x - s * p.y, s * p.x + c * p.y, p.z};
        p = Point{c * turned.x - s * turned.z + offset, turned.y, s * turned.x + c * turned.z};
        p = Point{std::round(p.x * unit) / unit, std::round(p.y * unit) / unit,
                  std::round(p.z * unit) / unit};
      }
      expect_surfaces(shape, std::vector<Expected>(6, plane));
    }
}

/// The faces of a shape, which are found in its order.
RS::Surface_faces faces_in_order(const Shape& shape)
{
  RS::Surface_faces found = RS::find_surface_faces(surface_of(shape));
  EXPECT_EQ(found.partition.number_of_parts(), std::size_t(shape.number_of_faces));
  EXPECT_EQ(found.partition,
            RS::Partition(std::vector<RS::Partition::Index>(shape.faces.begin(), shape.faces.end()),
                          std::size_t(shape.number_of_faces)));
  return found;
}

// A plate with a boss, which has a blind hole; the plate and a second boss below are one shaft.
TEST(FindSurfaceFaces, RolesAndExtents)
{
  const RS::Surface_faces found = faces_in_order(revolved(
    {{0, -4}, {2, -4}, {2, 0}, {3, 0}, {3, 1}, {1.5, 1}, {1.5, 3}, {0.5, 3}, {0.5, 2}, {0, 2}},
    32));
  using R = Face_role;
  EXPECT_EQ(found.roles, (std::vector<R>{R::BOSS, R::BOSS, R::NONE, R::NONE, R::NONE, R::BOSS,
                                         R::NONE, R::HOLE, R::HOLE}));
  const RS::Fitted_surface<>& wall = found.surfaces[5];
  EXPECT_NEAR(wall.highest - wall.lowest, 2, 1e-9);
  EXPECT_NEAR(wall.point.z + (wall.direction.z > 0 ? wall.lowest : -wall.highest), 1, 1e-9);
  EXPECT_NEAR(found.surfaces[4].highest, found.surfaces[4].lowest, 1e-9);
  // the floor of a groove is no boss, nor is a shaft without a step
  for (const auto role :
       faces_in_order(
         revolved({{0, 0}, {2, 0}, {2, 1}, {1.5, 1}, {1.5, 2}, {2, 2}, {2, 3}, {0, 3}}, 32))
         .roles)
    EXPECT_EQ(role, R::NONE);
}

/// An arc around a point, between two angles in right angles.
shapes_with_faces::Profile arc(double r, double z, double radius, double from, double to)
{
  constexpr int sides = 6;
  shapes_with_faces::Profile result;
  for (int i = 0; i <= sides; ++i) {
    const double angle = shapes_with_faces::pi / 2 * (from + (to - from) * i / sides);
    result.push_back({r + radius * std::cos(angle), z + radius * std::sin(angle)});
  }
  return result;
}

// What is rounded at both ends is no blend itself, nor is the end of a pin.
TEST(FindSurfaceFaces, RolesOfRoundedWalls)
{
  using R = Face_role;
  using shapes_with_faces::revolved_faces;
  EXPECT_EQ(faces_in_order(revolved_faces({{{6, 0}, {12, 0}},
                                           {{12, 0}, {12, 6}},
                                           {{12, 6}, {6, 6}},
                                           arc(6, 5, 1, 1, 2),
                                           {{5, 5}, {5, 1}},
                                           arc(6, 1, 1, 2, 3)},
                                          48))
              .roles,
            (std::vector<R>{R::NONE, R::NONE, R::NONE, R::BLEND, R::HOLE, R::BLEND}));
  EXPECT_EQ(faces_in_order(revolved_faces({{{0, 0}, {8, 0}},
                                           {{8, 0}, {8, 2}},
                                           {{8, 2}, {4, 2}},
                                           arc(4, 3, 1, 3, 2),
                                           {{3, 3}, {3, 6}},
                                           arc(2, 6, 1, 0, 1),
                                           {{2, 7}, {0, 7}}},
                                          48))
              .roles,
            (std::vector<R>{R::NONE, R::NONE, R::NONE, R::BLEND, R::BOSS, R::BLEND, R::NONE}));
  EXPECT_EQ(
    faces_in_order(revolved_faces({arc(0, 2, 2, 3, 4), {{2, 2}, {2, 6}}, arc(0, 6, 2, 0, 1)}, 48))
      .roles,
    (std::vector<R>{R::NONE, R::NONE, R::NONE}));
}

TEST(FindSurfaceFaces, CommonSurfacesAndAxes)
{
  const auto common = [](const Shape& shape) {
    return RS::find_common_surfaces(surface_of(shape), faces_in_order(shape));
  };
  using Numbers = std::vector<RS::Partition::Index>;
  const Shape grooved = revolved(
    {{0, 0}, {2, 0}, {2, 1}, {1.5, 1}, {1.5, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2.5}, {0, 2.5}}, 32);
  EXPECT_EQ(common(grooved), (Numbers{0, 1, 2, 3, 4, 1, 6, 7, 8}));
  EXPECT_EQ(RS::find_common_axes(faces_in_order(grooved)), (Numbers{0, 1, 2, 1, 4, 1, 6, 1, 8}));
  // equal fillets have different axes
  const Shape bar = filleted_bar(3, 1, 5, 6, 2);
  Numbers own(std::size_t(bar.number_of_faces));
  std::iota(own.begin(), own.end(), 0u);
  EXPECT_EQ(common(bar), own);
  EXPECT_EQ(RS::find_common_axes(faces_in_order(bar)), own);
}

// The region graph has the neighbors of faces, and the kinds of borders.
TEST(FindSurfaceFaces, Borders)
{
  const Shape bar = filleted_bar(3, 1, 5, 3, 2);
  const RS::Surface surface = surface_of(bar);
  const RS::Surface_faces found = faces_in_order(bar);
  auto graph = RS::build_region_adjacency_graph<RS::Surface_face_region_data,
                                                RS::Surface_face_section_data>(surface,
                                                                               found.partition);
  RS::annotate_surface_faces(graph, surface, found.partition, found);
  std::size_t smooth = 0, sharp = 0;
  for (auto range = edges(graph); range.first != range.second; ++range.first) {
    const auto section = *range.first;
    const bool is_end = target(section, graph) >= 8 || source(section, graph) >= 8;
    EXPECT_EQ(graph[section].is_smooth(), !is_end);
    ++(graph[section].is_smooth() ? smooth : sharp);
  }
  EXPECT_EQ(smooth, 8u);
  EXPECT_EQ(sharp, 16u);
}

// In units of the mesh and types of its kernel, also where the surface has another unit.
template <typename Mesh>
void expect_part_faces(double scale)
{
  const Shape shape = ring(2, 2, 1, 3, 24, 2);
  const Mesh mesh = test::to_mesh<Mesh>(test::scaled(soup_of(shape), scale));
  using Kernel = typename CGAL::Kernel_traits<
    typename boost::property_map_value<Mesh, CGAL::vertex_point_t>::type>::Kernel;
  std::vector<RS::Part_face<Kernel>> faces;
  auto map = test::face_map(mesh);
  const std::size_t number = RS::find_part_faces(mesh, map, std::back_inserter(faces));
  ASSERT_EQ(number, faces.size());
  const RS::Surface surface = RS::make_surface(mesh);
  const RS::Surface_faces found = RS::find_surface_faces(surface);
  EXPECT_EQ(RS::Partition::from_labels(test::labels_of(mesh, map)), found.partition);
  ASSERT_EQ(faces.size(), found.surfaces.size());
  double area = 0, border = 0;
  std::size_t holes = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const RS::Fitted_surface<>& s = found.surfaces[i];
    EXPECT_EQ(faces[i].surface.kind, s.kind);
    EXPECT_EQ(faces[i].role, found.roles[i]);
    EXPECT_EQ(faces[i].surface.radius, surface.unit() * s.radius);
    EXPECT_EQ(CGAL::to_double(faces[i].surface.point.y()), surface.unit() * s.point.y);
    EXPECT_EQ(CGAL::to_double(faces[i].surface.direction.z()), s.direction.z);
    EXPECT_EQ(faces[i].surface.highest, surface.unit() * s.highest);
    area += faces[i].area / scale / scale;
    if (faces[i].role == Face_role::HOLE)
      ++holes;
    for (const RS::Part_face_neighbor& n : faces[i].neighbors) {
      EXPECT_FALSE(n.is_smooth);
      border += n.length / scale;
      EXPECT_TRUE(
        std::any_of(faces[n.face].neighbors.begin(), faces[n.face].neighbors.end(),
                    [&](const auto& back) { return back.face == i && back.length == n.length; }));
    }
    if (s.has_axis())
      for (std::size_t j = 0; j < i; ++j)
        if (faces[j].surface.kind == Surface_kind::CYLINDER) {
          EXPECT_EQ(faces[i].first_on_axis, faces[j].first_on_axis);
        }
  }
  EXPECT_EQ(holes, 1u);
  EXPECT_NEAR(area, surface.area() * surface.unit() / scale * surface.unit() / scale, 1e-9 * area);
  EXPECT_GT(border, 0);
}

TEST(FindSurfaceFaces, AreasOfLargeUnitsAreNumbers)
{
  const std::vector<test::Point> points = {{0, 0, 0}, {1e160, 0, 0}, {0, 1e100, 0}};
  test::Surface_mesh mesh = test::to_surface_mesh(test::Soup{points, {{0, 1, 2}}});
  auto map = test::face_map(mesh);
  std::vector<RS::Part_face<test::Kernel>> faces;
  RS::find_part_faces(mesh, map, std::back_inserter(faces));
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_NEAR(faces[0].area, 5e259, 1e246);
}

TEST(FindSurfaceFaces, PartFacesAreInUnitsAndTypesOfTheMesh)
{
  for (const double scale : {1.0, 1e-3, 1e40}) {
    expect_part_faces<test::Surface_mesh>(scale);
    expect_part_faces<CGAL::Polyhedron_3<test::Kernel>>(scale);
  }
}

} // namespace find_surface_faces_test
