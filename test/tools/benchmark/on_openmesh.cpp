// SPDX-License-Identifier: GPL-3.0-or-later

// Before CGAL, as its manual says of OpenMesh's own headers.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "run_on_mesh.h"

#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

namespace speed_benchmark {

namespace {

struct Double_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Openmesh = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

/// By OpenMesh itself, since CGAL's functions convert points to float.
Openmesh::VertexHandle add_point(Openmesh& mesh, const Triangles::Point& p)
{
  return mesh.add_vertex(Openmesh::Point(p[0], p[1], p[2]));
}

} // namespace

std::unique_ptr<Subject> make_openmesh_subject(const Triangles& triangles)
{
  return std::make_unique<Mesh_subject<Openmesh>>(triangles, add_point);
}

} // namespace speed_benchmark
