// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/write_segmentation.h"

#include "write/Output_stream.h"
#include "write/Text_buffer.h"
#include "read/errors.h"
#include "read/read_marks.h"
#include "write/write_mesh.h"
#include "page/write_page.h"
#include "view/render_view.h"
#include "view/write_png.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace segment_mesh {

namespace {

void write_borders(std::ostream& out, Output_format format, const Result& result)
{
  const std::vector<Point>& points = result.input.soup.points;
  if (format == Output_format::VTP)
    write_borders_vtp(out, points, result.details.borders());
  else
    write_borders_obj(out, points, result.details.borders());
}

/// A mesh, the whole or a part of `result`; or, in a format that is not of meshes, all of `result`.
void write_segments(std::ostream& out, Output_format format, const Result& result,
                    const Labelled_mesh& mesh, const std::vector<Polyline>& feature_lines)
{
  switch (format) {
  case Output_format::SEG:
    return write_seg(out, result);
  case Output_format::PLY:
    return write_ply(out, mesh);
  case Output_format::OFF:
    return write_off(out, mesh);
  case Output_format::OBJ:
    return write_obj(out, mesh, feature_lines);
  case Output_format::VTP:
    return write_vtp(out, mesh);
  case Output_format::JSON:
    return write_json(out, result);
  case Output_format::CSV:
    return write_csv(out, result);
  case Output_format::PNG:
    return write_view(out, result);
  case Output_format::HTML:
    return write_html(out, result);
  case Output_format::GLB:
    return write_glb(out, mesh);
  case Output_format::THREE_MF:
    return write_3mf(out, mesh);
  }
}

/// \throws Output_error if the program was built without the library of a format
void check_libraries(const Output& output)
{
  const auto require = [&](Output_format format, bool can_write, const std::string& need) {
    if (output.format == format && !can_write)
      throw Output_error(output.file, need + ", and this program was built without it");
  };
  require(Output_format::HTML, can_write_pages(), "pages need three.js (Debian: libjs-three)");
  require(Output_format::GLB, can_write_glb(), ".glb needs tinygltf (Debian: libtinygltf-dev)");
  require(Output_format::THREE_MF, can_write_3mf(), ".3mf needs lib3mf (Debian: lib3mf-dev)");
}

/// The largest absolute value of a coordinate of a polygon.
double largest_coordinate(const Polygon_soup& soup)
{
  double largest = 0;
  for (const Polygon_soup::Polygon& polygon : soup.polygons)
    for (const std::size_t v : polygon)
      for (const double x : soup.points[v])
        largest = (std::max)(largest, std::fabs(x));
  return largest;
}

/// \throws Output_error if a format cannot represent the coordinates
void check_coordinates(const Output& output, const Polygon_soup& soup)
{
  using Limits = std::numeric_limits<float>;
  const bool is_3mf = output.format == Output_format::THREE_MF;
  if (!is_3mf && output.format != Output_format::GLB)
    return;
  const double most = is_3mf ? 1e9 /* of lib3mf */ : double((Limits::max)()),
               largest = largest_coordinate(soup);
  if (largest > most || (largest > 0 && largest < double((Limits::min)()))) {
    std::ostringstream text;
    text << "coordinates reach " << largest << ", this format can have some from "
         << double((Limits::min)()) << " to " << most;
    throw Output_error(output.file, text.str());
  }
}

void write_each_segment(const Output& output, const Result& result)
{
  const auto faces = faces_of_segments(result.segmentation.segment_of_face,
                                       result.segmentation.number_of_segments);
  for (std::size_t segment = 0; segment < faces.size(); ++segment) {
    const Polygon_soup part = extract_faces(result.input.soup, faces[segment]);
    Output_stream out(with_segment(output.file, std::to_string(segment)), output.compression);
    write_segments(out.stream(), output.format, result,
                   {part, std::vector<std::size_t>(part.polygons.size(), segment)}, {});
    out.commit();
  }
}

} // namespace

void write_segmentation(const Output& output, const Result& result)
{
  check_libraries(output);
  check_coordinates(output, result.input.soup);
  if (output.is_for_each_segment()) {
    write_each_segment(output, result);
    return;
  }
  Output_stream out(output.file, output.compression);
  if (output.content == Output_content::BORDERS)
    write_borders(out.stream(), output.format, result);
  else
    write_segments(out.stream(), output.format, result,
                   {result.input.soup, result.segmentation.segment_of_face},
                   output.format == Output_format::OBJ ? result.details.feature_lines()
                                                       : std::vector<Polyline>());
  out.commit();
}

void write_seg(std::ostream& out, const Result& result)
{
  Text_buffer text(out);
  for (std::size_t label : result.segmentation.segment_of_face)
    text << std::int64_t(label) << "\n";
}

void write_view(std::ostream& out, const Result& result)
{
  View_options options;
  options.viewpoint = result.viewpoint;
  options.colors = result.details.colors(result.coloring, result.segmentation.segment_of_face,
                                         result.segmentation.number_of_segments);
  options.marked_edges = lines_of_marks(result.marks, result.input);
  write_png_view(out, result.input.soup, result.segmentation.segment_of_face,
                 edges_of_lines(result.details.feature_lines()), options);
}

void write_html(std::ostream& out, const Result& result)
{
  write_page(
    out, {result.name, result.input.soup, result.segmentation, result.details, result.coloring});
}

} // namespace segment_mesh
