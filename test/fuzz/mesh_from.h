// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_FUZZ_MESH_FROM_H
#define CGAL_REGION_SEGMENTATION_TEST_FUZZ_MESH_FROM_H

#include "Bytes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Labels = std::vector<std::size_t>;

inline auto face_map(const Mesh& mesh, Labels& labels)
{
  return boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
}

/// Points, then polygons on them; those that would give an edge more than two faces are left out.
inline Mesh mesh_from(Bytes& bytes)
{
  Mesh mesh;
  for (std::size_t i = 0, n = 3 + bytes.below(62); i < n; ++i) {
    const double x = bytes.number(), y = bytes.number(), z = bytes.number();
    mesh.add_vertex({x, y, z});
  }
  while (!bytes.empty()) {
    std::vector<Mesh::Vertex_index> corners;
    for (std::size_t i = 0, n = 3 + bytes.below(4); i < n; ++i)
      corners.emplace_back(
        Mesh::Vertex_index(Mesh::size_type(bytes.below(mesh.number_of_vertices()))));
    if (std::set<Mesh::Vertex_index>(corners.begin(), corners.end()).size() == corners.size() &&
        CGAL::Euler::can_add_face(corners, mesh))
      CGAL::Euler::add_face(corners, mesh);
  }
  return mesh;
}

/// Whether the faces at every vertex form one fan, which one walk around the vertex meets.
inline bool has_only_manifold_vertices(const Mesh& mesh)
{
  std::vector<std::size_t> faces(mesh.number_of_vertices());
  for (const auto f : mesh.faces())
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      ++faces[v];
  for (const auto v : mesh.vertices())
    if (!mesh.is_isolated(v)) {
      for (const auto f : mesh.faces_around_target(mesh.halfedge(v)))
        faces[v] -= f != Mesh::null_face();
      if (faces[v] != 0)
        return false;
    }
  return true;
}

/// Those of vertices without a face, too.
inline bool has_only_finite_points(const Mesh& mesh)
{
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    if (!(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())))
      return false;
  }
  return true;
}

#endif // CGAL_REGION_SEGMENTATION_TEST_FUZZ_MESH_FROM_H
