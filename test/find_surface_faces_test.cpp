// SPDX-License-Identifier: LGPL-3.0-or-later

// Faces of tessellated shapes that are made by formula, with their surfaces.

#include <CGAL/Region_segmentation/find_surface_faces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <vector>

namespace {

namespace RS = CGAL::Region_segmentation;
using Point = RS::Double_3;
using Triangle = std::array<std::uint32_t, 3>;
using RS::Surface_kind;

const double pi = std::acos(-1.0);

/// Triangles with equal points merged, and the number of the face of each.
struct Shape
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<int> faces;
  int number_of_faces = 0;

  std::uint32_t vertex(const Point& p)
  {
    const auto key = [](double x) { return std::llround(x * 1e9); };
    const auto position = m_vertices.insert({{key(p.x), key(p.y), key(p.z)}, std::uint32_t(points.size())});
    if (position.second)
      points.push_back(p);
    return position.first->second;
  }

  void add_triangle(const Point& a, const Point& b, const Point& c, int face)
  {
    const Triangle t = {vertex(a), vertex(b), vertex(c)};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      return;
    triangles.push_back(t);
    faces.push_back(face);
  }

  /// A face over the parameters [0, 1] x [0, 1], as m x n quadrangles, each cut in two. du x dv points outwards.
  template <typename Function>
  void add_face(int m, int n, const Function& f)
  {
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < n; ++j) {
        const auto at = [&](int a, int b) { return f(double(a) / m, double(b) / n); };
        add_triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1), number_of_faces);
        add_triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1), number_of_faces);
      }
    ++number_of_faces;
  }

private:
  std::map<std::array<long long, 3>, std::uint32_t> m_vertices;
};

RS::Surface surface_of(const Shape& shape)
{
  using namespace RS;
  Surface surface;
  RS::internal::Surface_access s(surface);
  s.points.assign(shape.points.begin(), shape.points.end());
  s.first_corners.push_back(0);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> faces_of_edge;
  for (std::uint32_t f = 0; f < shape.triangles.size(); ++f) {
    Triangle t = shape.triangles[f];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    s.corners.insert(s.corners.end(), t.begin(), t.end());
    s.first_corners.push_back(std::uint32_t(s.corners.size()));
    const Point n = cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
    s.normals.push_back((1 / norm(n)) * n);
    s.areas.push_back(norm(n) / 2);
    s.area += norm(n) / 2;
    for (int i = 0; i < 3; ++i)
      faces_of_edge[std::minmax(t[i], t[(i + 1) % 3])].push_back(f);
  }
  s.length_unit = std::sqrt(s.area);
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> squared_lengths; // by higher, then lower face
  for (const auto& edge : faces_of_edge)
    if (edge.second.size() == 2)
      squared_lengths[{std::max(edge.second[0], edge.second[1]), std::min(edge.second[0], edge.second[1])}] =
        squared_norm(s.points[edge.first.first] - s.points[edge.first.second]);
  for (const auto& pair : squared_lengths) {
    s.higher_faces.push_back(pair.first.first);
    s.lower_faces.push_back(pair.first.second);
    s.squared_lengths.push_back(pair.second);
    s.flags.push_back(0);
  }
  return surface;
}

/// Expects the faces of the shape, and returns their surfaces, in the order of the faces.
std::vector<RS::Fitted_surface> expect_faces(const Shape& shape)
{
  const RS::Surface_faces found = RS::find_surface_faces(surface_of(shape));
  EXPECT_EQ(found.partition, RS::Partition::from_labels(shape.faces));
  EXPECT_EQ(found.surfaces.size(), std::size_t(shape.number_of_faces));
  std::vector<RS::Fitted_surface> result(shape.number_of_faces);
  for (std::size_t f = 0; f < shape.faces.size(); ++f)
    result[shape.faces[f]] = found.surfaces[found.partition[f]];
  return result;
}

template <typename Function>
void add_parallelogram(Shape& shape, int m, int n, const Point& o, const Point& u, const Function& v)
{
  shape.add_face(m, n, [&](double a, double b) { return o + a * u + b * v; });
}

Shape box(double x, double y, double z, int n)
{
  Shape s;
  const Point o{0, 0, 0}, u{x, 0, 0}, v{0, y, 0}, w{0, 0, z};
  add_parallelogram(s, n, n, o, v, u);
  add_parallelogram(s, n, n, w, u, v);
  add_parallelogram(s, n, n, o, u, w);
  add_parallelogram(s, n, n, v, w, u);
  add_parallelogram(s, n, n, o, w, v);
  add_parallelogram(s, n, n, u, v, w);
  return s;
}

/// A point of a circle around the z axis.
Point around(double radius, double turns, double z)
{
  return {radius * std::cos(2 * pi * turns), radius * std::sin(2 * pi * turns), z};
}

/// A ring of a height, outside and inside of given radii at its bottom and top.
Shape ring(double outer_bottom, double outer_top, double inner, double height, int turns, int rows)
{
  const auto mix = [](double a, double b, double t) { return a + t * (b - a); };
  Shape s;
  s.add_face(turns, rows, [&](double a, double b) { return around(mix(outer_bottom, outer_top, b), a, b * height); });
  s.add_face(rows, turns, [&](double a, double b) { return around(inner, b, a * height); });
  s.add_face(turns, 1, [&](double a, double b) { return around(mix(outer_top, inner, b), a, height); });
  s.add_face(1, turns, [&](double a, double b) { return around(mix(outer_bottom, inner, a), b, 0); });
  return s;
}

/// A bar along z of square section with rounded edges: faces are planes, fillets in turn, then the two ends.
Shape filleted_bar(double size, double radius, double length, int facets, int rows)
{
  Shape s;
  const auto corner = [&](int k) { return Point{(k % 4 == 0 || k % 4 == 3 ? 1 : -1) * size, (k % 4 < 2 ? 1 : -1) * size, 0}; };
  const auto on_fillet = [&](int k, double t, double z) {
    const Point p = corner(k), q = around(radius, (k % 4 + t) / 4.0, z);
    return Point{p.x + q.x, p.y + q.y, z};
  };
  for (int k = 0; k < 4; ++k) {
    s.add_face(1, rows, [&](double a, double b) {
      return (1 - a) * on_fillet(k, 1, b * length) + a * on_fillet(k + 1, 0, b * length);
    });
    s.add_face(facets, rows, [&](double a, double b) { return on_fillet(k, a, b * length); });
  }
  for (const double z : {0.0, length}) {
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i <= facets; ++i) {
        const Point p = on_fillet(k, double(i) / facets, z);
        const Point q = i < facets ? on_fillet(k, double(i + 1) / facets, z) : on_fillet(k + 1, 0, z);
        const Point center{0, 0, z};
        z > 0 ? s.add_triangle(center, p, q, s.number_of_faces) : s.add_triangle(center, q, p, s.number_of_faces);
      }
    ++s.number_of_faces;
  }
  return s;
}

Shape torus(double major, double minor, int m, int n)
{
  Shape s;
  s.add_face(m, n, [&](double a, double b) {
    return around(major + minor * std::cos(2 * pi * b), a, minor * std::sin(2 * pi * b));
  });
  return s;
}

/// A hemisphere on a disc.
Shape dome(double radius, int m, int n)
{
  Shape s;
  s.add_face(m, n, [&](double a, double b) {
    return around(radius * std::cos(pi / 2 * b), a, radius * std::sin(pi / 2 * b));
  });
  s.add_face(1, m, [&](double a, double b) { return around(radius * (1 - a), b, 0); });
  return s;
}

TEST(FindSurfaceFaces, Box)
{
  for (const int n : {1, 4})
    for (const RS::Fitted_surface& s : expect_faces(box(1, 2, 3, n)))
      EXPECT_EQ(s.kind, Surface_kind::PLANE);
}

TEST(FindSurfaceFaces, CylinderWithHole)
{
  for (const int turns : {12, 40})
    for (const int rows : {1, 3}) {
      const std::vector<RS::Fitted_surface> s = expect_faces(ring(2, 2, 1, 3, turns, rows));
      EXPECT_EQ(s[0].kind, Surface_kind::CYLINDER);
      EXPECT_NEAR(s[0].radius, 2, 1e-8);
      EXPECT_EQ(s[0].side, 1);
      EXPECT_EQ(s[1].kind, Surface_kind::CYLINDER);
      EXPECT_NEAR(s[1].radius, 1, 1e-8);
      EXPECT_EQ(s[1].side, -1);
      EXPECT_NEAR(std::fabs(s[1].direction.z), 1, 1e-12);
      EXPECT_EQ(s[2].kind, Surface_kind::PLANE);
    }
}

TEST(FindSurfaceFaces, Cone)
{
  const std::vector<RS::Fitted_surface> s = expect_faces(ring(3, 2, 1, 2, 24, 3));
  EXPECT_EQ(s[0].kind, Surface_kind::CONE);
  EXPECT_NEAR(s[0].angle, std::atan(0.5), 1e-7);
  EXPECT_NEAR(s[0].apex().z, 6, 1e-6);
  EXPECT_NEAR(s[0].direction.z, -1, 1e-9);
}

TEST(FindSurfaceFaces, SphereAndTorus)
{
  const std::vector<RS::Fitted_surface> s = expect_faces(dome(2, 24, 7));
  EXPECT_EQ(s[0].kind, Surface_kind::SPHERE);
  EXPECT_NEAR(s[0].radius, 2, 1e-7);
  EXPECT_EQ(s[1].kind, Surface_kind::PLANE);
  const std::vector<RS::Fitted_surface> t = expect_faces(torus(3, 1, 40, 16));
  EXPECT_EQ(t[0].kind, Surface_kind::TORUS);
  EXPECT_NEAR(t[0].radius, 3, 1e-6);
  EXPECT_NEAR(t[0].minor_radius, 1, 1e-6);
}

// Planes and fillets meet smoothly: their surfaces tell them apart.
TEST(FindSurfaceFaces, Fillets)
{
  for (const int facets : {3, 6})
    for (const int rows : {1, 5}) {
      const std::vector<RS::Fitted_surface> s = expect_faces(filleted_bar(3, 1, 5, facets, rows));
      for (int k = 0; k < 4; ++k) {
        EXPECT_EQ(s[2 * k].kind, Surface_kind::PLANE);
        EXPECT_EQ(s[2 * k + 1].kind, Surface_kind::CYLINDER);
        EXPECT_NEAR(s[2 * k + 1].radius, 1, 1e-8);
      }
    }
}

// A plane that is tangent to a cylinder of large radius.
TEST(FindSurfaceFaces, LargeRadius)
{
  const std::vector<RS::Fitted_surface> s = expect_faces(filleted_bar(1, 20, 5, 30, 8));
  EXPECT_EQ(s[0].kind, Surface_kind::PLANE);
  EXPECT_EQ(s[1].kind, Surface_kind::CYLINDER);
  EXPECT_NEAR(s[1].radius, 20, 1e-6);
}

TEST(FindSurfaceFaces, MotionScaleAndOrder)
{
  const unsigned seed = 31;
  SCOPED_TRACE(seed);
  const Shape bar = filleted_bar(3, 1, 5, 6, 5);
  for (const double scale : {1e-6, 1.0, 1e6}) {
    std::mt19937 random(seed);
    std::vector<std::size_t> order(bar.triangles.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::shuffle(order.begin(), order.end(), random);
    Shape moved;
    moved.number_of_faces = bar.number_of_faces;
    for (const Point& p : bar.points) // a rotation, a translation, a scaling
      moved.points.push_back(scale * Point{0.36 * p.x + 0.48 * p.y - 0.8 * p.z + 7, -0.8 * p.x + 0.6 * p.y - 9,
                                           0.48 * p.x + 0.64 * p.y + 0.6 * p.z + 20});
    for (const std::size_t f : order) {
      Triangle t = bar.triangles[f];
      std::rotate(t.begin(), t.begin() + f % 3, t.end());
      moved.triangles.push_back(t);
      moved.faces.push_back(bar.faces[f]);
    }
    EXPECT_NEAR(expect_faces(moved)[1].radius, scale, 1e-7 * scale);
  }
}

} // namespace
