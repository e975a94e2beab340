// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_SEGMENTATION_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_SEGMENTATION_H

#include "io/output_format.h"
#include "io/read_mesh.h"
#include "segmentation/run_segmentation.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace segment_mesh {

/// What an output is written from. References: it lives within one run.
struct Result
{
  const std::string& name; ///< of the input
  const Input_mesh& input;
  const Segmentation_settings& settings;
  const Segmentation& segmentation;
};

/// The segment of each face of the input's file.
std::vector<std::size_t> labels_of_faces(const Input_mesh& input, const Segmentation& segmentation);

/// Writes a result in the format that the ending of `file` names. Faces come in the order of the
/// input's file. The file appears whole or not at all.
/// \throws Output_error naming file and cause, Usage_error for another ending
void write_segmentation(const std::string& file, const Result& result);

/// \name One function a format
/// @{

/// The segment of a face on each line.
void write_seg(std::ostream& out, const Result& result);
/// Binary, little endian: double coordinates; for each face its points, a color and an int
/// `segment`.
void write_ply(std::ostream& out, const Result& result);
/// Colored faces: red, green and blue from 0 to 255 after the indices.
void write_off(std::ostream& out, const Result& result);
/// A group `segment_I` for each segment, entered again wherever the order of the faces comes back to
/// it, and, of two-step, a group `feature_lines` of `l` elements.
void write_obj(std::ostream& out, const Result& result);
/// See write_json.cpp.
void write_json(std::ostream& out, const Result& result);
/// A picture of the segments and the feature lines, see `render_view()`.
void write_view(std::ostream& out, const Result& result);
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_SEGMENTATION_H
