// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_STEP_TEXT_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_STEP_TEXT_H

#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <string>
#include <vector>

namespace mesh_to_step {

/// A shape that was read from a STEP file, and the names of its faces, in its order: OpenCASCADE
/// may read them in another order than they were written in.
struct Named_shape
{
  TopoDS_Shape shape; ///< null if it cannot be read
  std::vector<std::string> face_names;
};

/// `body_1` of the first one.
std::string body_name(std::size_t body);

/// The text of a STEP file, lengths in mm; empty if the shape cannot be written. Solids get the
/// names of bodies.
///
/// \param face_names of the faces, in the order of the shape
std::string step_text(const TopoDS_Shape& shape, const std::vector<std::string>& face_names);

/// The shape in such a text.
Named_shape shape_of(const std::string& step_text);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_STEP_TEXT_H
