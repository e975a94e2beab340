// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_store.h"

#include "make_triangles.h"
#include "subdivided_by_loop.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

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

} // namespace

Triangles Mesh_store::make_triangles(const Mesh_wanted& mesh) const
{
  if (mesh.shape == Shape::TORUS)
    return make_torus(mesh.faces);
  if (mesh.shape == Shape::LOOP)
    return make_subdivided(m_folder, mesh.faces, subdivided_by_loop);
  Triangles triangles = make_subdivided(m_folder, mesh.faces, subdivided);
  if (mesh.shape == Shape::NOISY)
    return roughened(std::move(triangles), amplitude_of_noise);
  return mesh.shape == Shape::SHUFFLED ? shuffled(triangles) : triangles;
}

void Mesh_store::make_surface_mesh(const Mesh_wanted& mesh)
{
  m_other.reset();
  m_sums.reset();
  m_surface_mesh.reset();
  m_triangles = make_triangles(mesh);
  m_surface_mesh = make_surface_mesh_subject(m_triangles);
  m_mesh = mesh;
  if (mesh.shape == Shape::TORUS)
    m_triangles = {}; // the largest mesh, and in one type alone
}

std::optional<Subjects> Mesh_store::get(const Mesh_wanted& mesh)
{
  if (!m_surface_mesh || !mesh.has_same_triangles(m_mesh))
    make_surface_mesh(mesh);
  if (mesh.type == Mesh_type::SURFACE_MESH)
    return Subjects{*m_surface_mesh, *m_surface_mesh};
  if (!m_other || mesh.type != m_type_of_other) {
    m_other.reset();
    m_other = mesh.type == Mesh_type::POLYHEDRON ? make_polyhedron_subject(m_triangles)
                                                 : make_openmesh_subject(m_triangles);
    m_type_of_other = mesh.type;
  }
  if (!m_other)
    return std::nullopt;
  return Subjects{*m_other, *m_surface_mesh};
}

const Sums& Mesh_store::sums()
{
  if (!m_sums)
    m_sums = std::make_unique<Sums>(m_surface_mesh->number_of_faces());
  return *m_sums;
}

} // namespace speed_benchmark
