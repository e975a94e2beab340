// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_SPEED_MAKE_MESH_H
#define CGAL_REGION_SEGMENTATION_TEST_SPEED_MAKE_MESH_H

#include "Triangles.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace speed_benchmark {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

inline Mesh make_mesh(const Triangles& triangles)
{
  using Vertex = Mesh::Vertex_index;
  Mesh mesh;
  for (const auto& p : triangles.points)
    mesh.add_vertex({p[0], p[1], p[2]});
  for (const auto& t : triangles.corners)
    mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  return mesh;
}

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_SPEED_MAKE_MESH_H
