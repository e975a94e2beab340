// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_FREEFORM_SURFACE_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_FREEFORM_SURFACE_H

#include "part_surface.h"

namespace mesh_to_step {

/// A B-spline surface through the vertices of a freeform face, within a tolerance, and through
/// those of its border, within a twentieth of it, with what projects to it; null where none is
/// found. The face is flattened, and its control points are of least squares. Normals
/// point as those of the triangles.
///
/// \param mesh the triangles of the face, whose border has many points of its edges
Handle(ShapeAnalysis_Surface) freeform_surface(Mesh mesh, double tolerance);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_FREEFORM_SURFACE_H
