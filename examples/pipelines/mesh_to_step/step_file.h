// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_STEP_FILE_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_STEP_FILE_H

#include <TopoDS_Shape.hxx>

#include <string>

namespace mesh_to_step {

/// Whether the file was written. Lengths are in mm.
bool write_step(const TopoDS_Shape& shape, const std::string& file);

/// The shape in a file; null if it cannot be read.
TopoDS_Shape read_step(const std::string& file);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_STEP_FILE_H
