// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_CHECK_SOLID_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_CHECK_SOLID_H

#include "make_solid.h"
#include "step_text.h"

#include <cstddef>
#include <string>
#include <vector>

namespace mesh_to_step {

/// The largest distances between a face of a solid and the triangles that it was made of.
struct Face_errors
{
  double of_vertices = 0; ///< from the vertices to the surface
  double of_surface = 0;  ///< from points of the face to the triangles
  double of_sides = 0;    ///< from midpoints of triangles and of their sides to the surface: coarse
                          ///< triangles are far from what they stand for
  double of_edges = 0;    ///< from points of the edges of the face to its surface
};

/// What is measured of a solid.
struct Measured_body
{
  double volume = 0, area = 0;
  std::vector<std::string> face_names;
};

/// What is measured of a shape that is read from a file.
struct Certificate
{
  bool is_valid = false;  ///< as OpenCASCADE checks it
  bool is_closed = false; ///< whether it is solids, each edge of which is between two faces
  std::vector<Measured_body> bodies;
  std::size_t number_of_faces = 0;
  double volume = 0, area = 0;    ///< of all bodies
  double gap = 0;                 ///< the largest distance between an edge and its faces
  double volume_error = 0;        ///< what the volume may differ by from that of the mesh: areas of
                                  ///< triangles by the distances of their faces
  std::vector<Face_errors> faces; ///< by label, if the shape has the faces that were made
};

/// Measures a shape, which is `solid` as a file has it, and compares it with the mesh.
///
/// \param names of the faces of `solid`, in its order
Certificate compare(const Named_shape& read, const Solid& solid,
                    const std::vector<std::string>& names);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_CHECK_SOLID_H
