// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_STEP_TEXT_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_STEP_TEXT_H

#include "../../example_mesh.h"

#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

namespace mesh_to_step {

/// The text of a STEP file, lengths in mm; empty if the shape cannot be written.
std::string step_text(const TopoDS_Shape& shape);

/// The shape in such a text; null if it cannot be read.
TopoDS_Shape shape_of(const std::string& step_text);

/// A part as a STEP file.
struct Step_part
{
  std::string text;
  /// Whether the text, as it is read, is of solids that are closed, valid, and of the volume of the
  /// mesh.
  bool is_solid = false;
  std::vector<std::string> remarks; ///< sentences: faces that are facets, what is wrong
};

/// \param mesh of triangles
/// \throws Standard_Failure by OpenCASCADE, and for a part smaller than .001 or larger than 1e12
Step_part make_step_part(Mesh mesh);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_STEP_TEXT_H
