// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_SEGMENTATION_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_SEGMENTATION_H

#include "write/output_format.h"
#include "read/errors.h"
#include "read/read_mesh.h"
#include "segmentation/Segmentation_details.h"
#include "segmentation/run_segmentation.h"
#include "view/render_view.h"

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
  const Side_files& side_files;
  const Segmentation& segmentation;
  const Segmentation_details& details;
  const View_options& view;               ///< of a picture; what is up also of a page
  Coloring coloring = Coloring::SEGMENTS; ///< of a picture or page
};

/// Writes a result in the format of `output`, or each of its segments. Faces come in the order of
/// the input's file. A file appears whole or not at all. \throws Output_error naming file and cause
/// \returns remarks on a solid
Remarks write_segmentation(const Output& output, const Result& result);

/// \name Formats that are not only of meshes
/// @{

/// The segment of a face on each line.
void write_seg(std::ostream& out, const Result& result);
/// See write_json.cpp.
void write_json(std::ostream& out, const Result& result);
/// A table of the segments: see write_csv.cpp.
void write_csv(std::ostream& out, const Result& result);
/// A picture of the segments and the feature lines, see `render_view()`.
void write_view(std::ostream& out, const Result& result);
/// A page to view and rotate the mesh, see `write_page()`.
void write_html(std::ostream& out, const Result& result);

struct Step_text
{
  std::string text;
  Remarks remarks; ///< on faces that are facets
};

/// A solid of the faces of a machine part, whatever the segments are, by the program
/// `mesh_to_step`. \throws Output_error if there is none, or if that program is not on the PATH
Step_text make_step(const Output& output, const Result& result);
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_SEGMENTATION_H
