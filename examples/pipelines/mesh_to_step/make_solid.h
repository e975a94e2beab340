// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_MAKE_SOLID_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_MAKE_SOLID_H

#include "Trimmed_faces.h"

#include <TopoDS_Shape.hxx>

#include <set>
#include <vector>

namespace mesh_to_step {

/// Whether a face that cannot be made of its surface may stay its triangles.
enum class Facets { REFUSED, ALLOWED };

/// A part as a boundary representation.
struct Solid
{
  TopoDS_Shape shape; ///< a solid; a compound of several
  Mesh mesh;          ///< of the triangles, with their labels
  Labels labels;      ///< by triangle: the faces of the part, then triangles of some of them
  std::size_t number_of_labels = 0;
  std::vector<std::size_t> label_of_face; ///< by face of `shape`, in its order
  std::set<std::size_t> faces_as_facets;  ///< the faces that cannot be made of their surfaces
};

/// Makes a solid of the faces of a machine part: each is its surface, trimmed by edges that it
/// shares with its neighbors; a freeform face is a B-spline surface. A face stays its triangles, if
/// that is allowed, where it cannot be made, or has not about their area.
///
/// \param mesh closed, of triangles
/// \param face_of_triangle, part_faces as found by `find_part_faces()`
Solid make_solid(Mesh mesh, const Labels& face_of_triangle, const Part_faces& part_faces,
                 Facets facets = Facets::ALLOWED);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_MAKE_SOLID_H
