// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_OUTPUT_FORMAT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_OUTPUT_FORMAT_H

#include <string>

namespace segment_mesh {

/// The formats that are written.
enum class Output_format { SEG, PLY, OFF, OBJ, JSON, PNG };

/// The format that the ending of `file` names, in upper or lower case.
/// \throws Usage_error for another ending
Output_format output_format(const std::string& file);

/// Whether a format holds more than labels, and so needs `Detail::ALL`.
bool needs_details(Output_format format);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_OUTPUT_FORMAT_H
