// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_MESH_OF_H
#define CGAL_REGION_SEGMENTATION_TEST_MESH_OF_H

#include "bodies.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>

#include <cstddef>
#include <utility>
#include <vector>

/// Triangles of a shape, by OpenCASCADE.
inline mesh_to_step::Mesh mesh_of(const TopoDS_Shape& shape)
{
  constexpr double deflection = 0.02, angle = 0.2;
  BRepMesh_IncrementalMesh(shape, deflection, false, angle);
  std::vector<mesh_to_step::Point> points;
  std::vector<std::vector<std::size_t>> triangles;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    TopLoc_Location place;
    const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(face.Current()), place);
    const std::size_t before = points.size();
    for (int i = 1; i <= mesh->NbNodes(); ++i)
      points.emplace_back(mesh->Node(i).X(), mesh->Node(i).Y(), mesh->Node(i).Z());
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
      std::vector<std::size_t> triangle;
      for (int k = 1; k <= 3; ++k)
        triangle.push_back(before + std::size_t(mesh->Triangle(i).Value(k)) - 1);
      if (face.Current().Orientation() == TopAbs_REVERSED)
        std::swap(triangle[1], triangle[2]);
      triangles.push_back(triangle);
    }
  }
  return mesh_to_step::make_bodies(points, triangles);
}

#endif // CGAL_REGION_SEGMENTATION_TEST_MESH_OF_H
