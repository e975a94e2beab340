// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/run_on_mesh.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>

namespace segment_mesh {

namespace {

struct Double_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Double_traits>;

/// By OpenMesh itself, since CGAL's functions put points into it by way of float.
Mesh make_mesh(const Polygon_soup& soup)
{
  Mesh mesh;
  std::vector<Mesh::VertexHandle> vertices;
  for (const Point& p : soup.points)
    vertices.push_back(mesh.add_vertex(Mesh::Point(p[0], p[1], p[2])));
  std::vector<Mesh::VertexHandle> corners;
  for (const Polygon_soup::Polygon& polygon : soup.polygons) {
    corners.clear();
    for (std::size_t i : polygon)
      corners.push_back(vertices[i]);
    if (!mesh.add_face(corners).is_valid())
      throw Not_a_manifold();
  }
  return mesh;
}

} // namespace

Segmentation run_on_openmesh(const Polygon_soup& soup, const Marks& marks,
                             const Segmentation_settings& settings,
                             const Progress_listener& listener)
{
  return run_on_mesh(make_mesh(soup), marks, settings, listener);
}

bool is_available(Mesh_type)
{
  return true;
}

} // namespace segment_mesh
