// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_OUTPUT_FORMAT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_OUTPUT_FORMAT_H

#include "write/Whole_file.h"

#include <cstddef>
#include <string>

namespace segment_mesh {

/// The formats that are written.
enum class Output_format {
  SEG,
  PLY,
  OFF,
  OBJ,
  VTP,
  JSON,
  CSV,
  PNG,
  HTML,
  GLB,
  THREE_MF,
  STL,
  MSH,
  STEP
};

/// What of a segmentation is written; solids are closed segments; a mesh that is painted is in one
/// piece.
enum class Output_content { SEGMENTS, SOLIDS, PAINTED, BORDERS };

enum class Compression { NONE, GZIP };

/// In the name of an output: a file for each segment.
constexpr const char* segment_placeholder = "{segment}";

struct Output
{
  std::string file; ///< `standard_output` for all names of stdout
  Output_format format = Output_format::SEG;
  Output_content content = Output_content::SEGMENTS;
  Compression compression = Compression::NONE;

  bool is_stdout() const { return file == standard_output; }
  bool is_for_each_segment() const { return file.find(segment_placeholder) != std::string::npos; }
};

/// The name with this number in place of each `{segment}`.
std::string with_segment(const std::string& file, const std::string& number);

/// The file of materials beside a file in .obj format, which refers to it by name: NAME.mtl beside
/// NAME.obj or NAME.obj.gz. Empty of another format, and of what is written directly.
std::string material_library(const Output& output);

/// Whether meshes in this format have the names of their segments.
bool has_names(Output_format format);

/// An output in the format that the ending of a file names in upper or lower case, before a last
/// ".gz" for a compressed one, or in the format that stands before the file and a colon: `csv:-`.
/// Solids that are asked for are segments where the format is not of meshes, and so is what is to
/// be painted but in a format other than .3mf. \throws Usage_error if the ending names no format,
/// or if what is to be written cannot be in this format
Output make_output(const std::string& text, Output_content content = Output_content::SEGMENTS);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_OUTPUT_FORMAT_H
