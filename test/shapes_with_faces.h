// SPDX-License-Identifier: GPL-3.0-or-later

// Tessellated shapes that are made by formula, with the face of each triangle.

#ifndef CGAL_REGION_SEGMENTATION_TEST_SHAPES_WITH_FACES_H
#define CGAL_REGION_SEGMENTATION_TEST_SHAPES_WITH_FACES_H

#include "meshes.h"

#include <CGAL/Region_segmentation/Support/Double_3.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace shapes_with_faces {

using Point = CGAL::Region_segmentation::Double_3;
using Triangle = std::array<std::uint32_t, 3>;

inline const double pi = std::acos(-1.0);

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
    const auto position = m_vertices.insert(
      {{key(p.x), key(p.y), key(p.z)}, std::uint32_t(points.size())});
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

  /// A face over the parameters [0, 1] x [0, 1], as m x n quadrangles, each cut in two. du x dv
  /// points outwards.
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

inline test::Soup soup_of(const Shape& shape)
{
  test::Soup soup;
  for (const Point& p : shape.points)
    soup.points.push_back({p.x, p.y, p.z});
  for (const Triangle& t : shape.triangles)
    soup.polygons.push_back({t.begin(), t.end()});
  return soup;
}

template <typename Function>
void add_parallelogram(Shape& shape, int m, int n, const Point& o, const Point& u,
                       const Function& v)
{
  shape.add_face(m, n, [&](double a, double b) { return o + a * u + b * v; });
}

inline Shape box(double x, double y, double z, int n)
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
inline Point around(double radius, double turns, double z)
{
  return {radius * std::cos(2 * pi * turns), radius * std::sin(2 * pi * turns), z};
}

/// A ring of a height, outside and inside of given radii at its bottom and top.
inline Shape ring(double outer_bottom, double outer_top, double inner, double height, int turns,
                  int rows)
{
  const auto mix = [](double a, double b, double t) { return a + t * (b - a); };
  Shape s;
  s.add_face(turns, rows, [&](double a, double b) {
    return around(mix(outer_bottom, outer_top, b), a, b * height);
  });
  s.add_face(rows, turns, [&](double a, double b) { return around(inner, b, a * height); });
  s.add_face(turns, 1,
             [&](double a, double b) { return around(mix(outer_top, inner, b), a, height); });
  s.add_face(1, turns,
             [&](double a, double b) { return around(mix(outer_bottom, inner, a), b, 0); });
  return s;
}

/// A bar along z of square section with rounded edges: faces are planes, fillets in turn, then the
/// two ends.
inline Shape filleted_bar(double size, double radius, double length, int facets, int rows)
{
  Shape s;
  const auto corner = [&](int k) {
    return Point{(k % 4 == 0 || k % 4 == 3 ? 1 : -1) * size, (k % 4 < 2 ? 1 : -1) * size, 0};
  };
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
        const Point q = i < facets ? on_fillet(k, double(i + 1) / facets, z)
                                   : on_fillet(k + 1, 0, z);
        const Point center{0, 0, z};
        z > 0 ? s.add_triangle(center, p, q, s.number_of_faces)
              : s.add_triangle(center, q, p, s.number_of_faces);
      }
    ++s.number_of_faces;
  }
  return s;
}

/// Pairs r, z.
using Profile = std::vector<std::array<double, 2>>;

/// The surface of revolution of profiles around the z axis: a face for each, and of it a row of
/// facets for each side. Outside is to the right.
inline Shape revolved_faces(const std::vector<Profile>& profiles, int turns)
{
  Shape s;
  for (const Profile& profile : profiles) {
    const int rows = int(profile.size()) - 1;
    s.add_face(turns, rows, [&](double a, double b) {
      const std::array<double, 2>& p = profile[std::size_t(std::lround(b * rows))];
      return around(p[0], a, p[1]);
    });
  }
  return s;
}

/// The same of a polygon, with a face for each side.
inline Shape revolved(const Profile& polygon, int turns)
{
  std::vector<Profile> sides;
  for (std::size_t i = 1; i < polygon.size(); ++i)
    sides.push_back({polygon[i - 1], polygon[i]});
  return revolved_faces(sides, turns);
}

inline Shape torus(double major, double minor, int m, int n)
{
  Shape s;
  s.add_face(m, n, [&](double a, double b) {
    return around(major + minor * std::cos(2 * pi * b), a, minor * std::sin(2 * pi * b));
  });
  return s;
}

/// A hemisphere on a disc.
inline Shape dome(double radius, int m, int n)
{
  Shape s;
  s.add_face(m, n, [&](double a, double b) {
    return around(radius * std::cos(pi / 2 * b), a, radius * std::sin(pi / 2 * b));
  });
  s.add_face(1, m, [&](double a, double b) { return around(radius * (1 - a), b, 0); });
  return s;
}

} // namespace shapes_with_faces

#endif // CGAL_REGION_SEGMENTATION_TEST_SHAPES_WITH_FACES_H
