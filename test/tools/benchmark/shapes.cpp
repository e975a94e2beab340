// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes.h"

#include "make_triangles.h"

#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace speed_benchmark {

namespace {

/// In units of the mean length of an edge: there is a first region for every fourth face then.
constexpr double amplitude_of_noise = 0.2;

std::string find_file(const std::string& folder, const std::string& name)
{
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.path().filename() == name)
        return entry.path().string();
  throw std::runtime_error("no " + name + " in '" + folder + "'");
}

/// A scan of a statue's head, with holes, and a model, closed: subdivided they have 10,000, 40,000,
/// 160,000 or 67,000, 270,000, 1.1, 4.3, 17 million faces, and so on.
struct Base
{
  const char* file;
  double faces;
};
constexpr Base bases[] = {{"homer.off", 9856}, {"lion-head.off", 16674}};

/// `subdivide`: makes four triangles of each.
template <typename Subdivide>
Triangles make_subdivided(const std::string& folder, std::size_t faces, const Subdivide& subdivide)
{
  const Base* nearest = nullptr;
  int levels = 0;
  double least = 0;
  for (const Base& base : bases) {
    const double exact = std::log(double(faces) / base.faces) / std::log(4.0);
    const double whole = std::max(0.0, std::round(exact));
    if (!nearest || std::abs(exact - whole) < least) {
      nearest = &base;
      levels = int(whole);
      least = std::abs(exact - whole);
    }
  }
  Triangles triangles = read_triangles(find_file(folder, nearest->file));
  for (; levels > 0; --levels)
    triangles = subdivide(triangles);
  return triangles;
}

/// With the creases of at most 100,000 faces: alone, a fine torus would have none.
Triangles make_torus(std::size_t faces)
{
  int levels = 0;
  for (; faces > 100000; faces /= 4)
    ++levels;
  Triangles triangles = wavy_torus(faces);
  for (; levels > 0; --levels)
    triangles = subdivided(triangles);
  return triangles;
}

/// Splits every triangle into four by Loop's scheme, which smooths creases away. Faces are in the
/// order of `CGAL::Subdivision_method_3`: the four are not side by side.
Triangles subdivided_by_loop(const Triangles& coarse)
{
  Surface_mesh mesh = make_surface_mesh(coarse);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
  Triangles result;
  for (const auto v : mesh.vertices())
    result.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    result.corners.push_back({std::uint32_t(mesh.source(h)), std::uint32_t(mesh.target(h)),
                              std::uint32_t(mesh.target(mesh.next(h)))});
  }
  return result;
}

} // namespace

Surface_mesh make_surface_mesh(const Triangles& triangles)
{
  Surface_mesh mesh;
  mesh.reserve(triangles.points.size(), triangles.corners.size() * 3 / 2, triangles.corners.size());
  for (const Triangles::Point& p : triangles.points)
    mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  using Vertex = Surface_mesh::Vertex_index;
  for (const Triangles::Corners& t : triangles.corners)
    if (mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) == Surface_mesh::null_face())
      throw std::runtime_error("the triangles are no manifold");
  return mesh;
}

Triangles make_shape(const std::string& shape, std::size_t faces, const std::string& folder)
{
  if (shape == "torus")
    return make_torus(faces);
  if (shape == "loop")
    return make_subdivided(folder, faces, subdivided_by_loop);
  Triangles triangles = make_subdivided(folder, faces, subdivided);
  if (shape == "noisy")
    return roughened(std::move(triangles), amplitude_of_noise);
  return shape == "shuffled" ? shuffled(triangles) : triangles;
}

} // namespace speed_benchmark
