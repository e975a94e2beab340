// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_FREEFORM_SURFACE_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_FREEFORM_SURFACE_H

#include "part_mesh.h"

#include <Geom_Surface.hxx>
#include <gp_Pnt.hxx>

#include <vector>

namespace mesh_to_step {

/// A point of an edge of the solid, beside the side of a triangle from one vertex to another.
struct Edge_point
{
  Mesh::Vertex_index from, to;
  double share; ///< of the way between them
  gp_Pnt point;
};

/// A B-spline surface through the vertices of a freeform face, within a tolerance, and through
/// points of its edges, within a twentieth of it; null where none is found. The face is flattened
/// conformally, and its control points are of least squares.
///
/// \param triangles those of the face
Handle(Geom_Surface)
  freeform_surface(const Mesh& triangles, const std::vector<Edge_point>& edges, double tolerance);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_FREEFORM_SURFACE_H
