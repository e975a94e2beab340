// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes.h"

#include "make_triangles.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace shapes {

namespace {

using Point = Mesh::Point;
using Vertex = Mesh::Vertex_index;

constexpr double pi = 3.14159265358979323846;

Point on_circle(double turn, double radius, double z)
{
  return Point(radius * std::cos(2 * pi * turn), radius * std::sin(2 * pi * turn), z);
}

Point on_sphere(std::mt19937& random)
{
  const double z = double(random()) / double(random.max()) * 2 - 1,
               turn = double(random()) / double(random.max());
  return on_circle(turn, std::sqrt(1 - z * z), z);
}

Vertex midpoint_moved(Mesh& mesh, const Point& p, double x, double y, double z)
{
  return mesh.add_vertex(Point(p.x() + x, p.y() + y, p.z() + z));
}

/// `depth`: how far every second vertex of the rim is below its neighbors
Mesh cone_with_folds(std::size_t faces, double depth)
{
  Mesh mesh;
  const Vertex apex = mesh.add_vertex(Point(0, 0, 1));
  for (std::size_t i = 0; i < faces; ++i)
    mesh.add_vertex(on_circle(double(i) / double(faces), 1, i % 2 ? -depth : 0));
  for (std::size_t i = 0; i < faces; ++i)
    mesh.add_face(apex, Vertex(Mesh::size_type(1 + i)),
                  Vertex(Mesh::size_type(1 + (i + 1) % faces)));
  return mesh;
}

} // namespace

Mesh cone(std::size_t faces)
{
  return cone_with_folds(faces, 0);
}

Mesh folded_cone(std::size_t faces)
{
  return cone_with_folds(faces, 10. / double(faces));
}

Mesh star(std::size_t faces)
{
  Mesh mesh;
  std::vector<Vertex> corners;
  for (std::size_t i = 0; i < faces; ++i)
    corners.push_back(mesh.add_vertex(on_circle(double(i) / double(faces), 1, 0)));
  mesh.add_face(corners);
  for (std::size_t i = 0; i < faces; ++i) {
    const Vertex tip = mesh.add_vertex(on_circle((double(i) + 0.5) / double(faces), 1.1, 1));
    mesh.add_face(corners[(i + 1) % faces], corners[i], tip);
  }
  return mesh;
}

Mesh triangles_at_one_edge(std::size_t faces)
{
  Mesh mesh;
  for (std::size_t i = 0; i < faces; ++i) {
    const Vertex a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(0, 0, 1));
    mesh.add_face(a, b,
                  mesh.add_vertex(on_circle(double(i) / 2 / pi, 1, double(i) / double(faces))));
  }
  return mesh;
}

Mesh polygons_on_ten_points(std::size_t faces)
{
  Mesh mesh;
  std::mt19937 random(1);
  std::vector<Point> points;
  for (int i = 0; i < 10; ++i)
    points.push_back(on_sphere(random));
  for (std::size_t f = 0; f < faces; ++f) {
    std::shuffle(points.begin(), points.end(), random);
    std::vector<Vertex> corners;
    for (std::size_t i = 0; i < 3 + f % 6; ++i)
      corners.push_back(mesh.add_vertex(points[i]));
    mesh.add_face(corners);
  }
  return mesh;
}

Mesh tetrahedra(std::size_t faces)
{
  Mesh mesh;
  std::mt19937 random(1);
  for (std::size_t i = 0; i < faces / 4; ++i) {
    const Point p = on_sphere(random);
    const Vertex a = mesh.add_vertex(p), b = midpoint_moved(mesh, p, 0.02, 0, 0),
                 c = midpoint_moved(mesh, p, 0, 0.02, 0), d = midpoint_moved(mesh, p, 0, 0, 0.02);
    mesh.add_face(a, c, b);
    mesh.add_face(a, b, d);
    mesh.add_face(b, c, d);
    mesh.add_face(c, a, d);
  }
  return mesh;
}

Mesh folded_strip(std::size_t faces)
{
  Mesh mesh;
  for (std::size_t i = 0; i < faces + 2; ++i)
    mesh.add_vertex(Point(double(i), double(i % 2), double(i / 2 % 2)));
  for (std::size_t i = 0; i < faces; ++i)
    mesh.add_face(Vertex(Mesh::size_type(i + i % 2)), Vertex(Mesh::size_type(i + 1 - i % 2)),
                  Vertex(Mesh::size_type(i + 2)));
  return mesh;
}

Mesh torus_and_far_triangle(std::size_t faces)
{
  Mesh mesh = speed_benchmark::make_mesh(speed_benchmark::wavy_torus(faces));
  const Vertex a = mesh.add_vertex(Point(1e6, 0, 0)), b = mesh.add_vertex(Point(1e6, 1, 0));
  mesh.add_face(a, b, mesh.add_vertex(Point(1e6, 0, 1)));
  return mesh;
}

} // namespace shapes
