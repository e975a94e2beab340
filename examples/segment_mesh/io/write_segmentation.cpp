// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write_segmentation.h"

#include "io/Text_buffer.h"
#include "io/Whole_file.h"
#include "io/little_endian.h"
#include "view/render_view.h"
#include "view/segment_colors.h"
#include "view/write_png.h"

#include <algorithm>
#include <cstdint>

namespace segment_mesh {

namespace {

void write_point(Text_buffer& text, const Point& p)
{
  text << p[0] << " " << p[1] << " " << p[2] << "\n";
}

bool has_large_face(const Polygon_soup& soup)
{
  return std::any_of(soup.polygons.begin(), soup.polygons.end(),
                     [](const Polygon_soup::Polygon& polygon) { return polygon.size() > 255; });
}

std::string ply_header(const Polygon_soup& soup)
{
  return "ply\n"
         "format binary_little_endian 1.0\n"
         "element vertex " +
         std::to_string(soup.points.size()) +
         "\n"
         "property double x\n"
         "property double y\n"
         "property double z\n"
         "element face " +
         std::to_string(soup.polygons.size()) +
         "\n"
         "property list " +
         (has_large_face(soup) ? "uint" : "uchar") +
         " int vertex_indices\n"
         "property uchar red\n"
         "property uchar green\n"
         "property uchar blue\n"
         "property int segment\n"
         "end_header\n";
}

} // namespace

std::vector<std::size_t> labels_of_faces(const Input_mesh& input, const Segmentation& segmentation)
{
  std::vector<std::size_t> labels;
  labels.reserve(input.mesh_face_of_face.size());
  for (std::size_t f : input.mesh_face_of_face)
    labels.push_back(segmentation.segment_of_face[f]);
  return labels;
}

void write_segmentation(const std::string& file, const Result& result)
{
  using Writer = void (*)(std::ostream&, const Result&);
  // In the order of Output_format.
  constexpr Writer writers[] = {write_seg, write_ply, write_off, write_obj, write_json,
                                write_view};
  const Writer write = writers[std::size_t(output_format(file))];
  Whole_file whole(file);
  write(whole.stream(), result);
  whole.commit();
}

void write_seg(std::ostream& out, const Result& result)
{
  Text_buffer text(out);
  for (std::size_t label : labels_of_faces(result.input, result.segmentation))
    text << label << "\n";
}

void write_ply(std::ostream& out, const Result& result)
{
  const Polygon_soup& soup = result.input.soup;
  const bool has_wide_sizes = has_large_face(soup);
  std::string bytes = ply_header(soup);
  for (const Point& p : soup.points)
    for (double coordinate : p)
      append_little_endian(bytes, coordinate);
  const std::vector<std::size_t> labels = labels_of_faces(result.input, result.segmentation);
  for (std::size_t f = 0; f < labels.size(); ++f) {
    const Polygon_soup::Polygon& polygon = soup.polygons[f];
    if (has_wide_sizes)
      append_little_endian(bytes, std::uint32_t(polygon.size()));
    else
      append_little_endian(bytes, std::uint8_t(polygon.size()));
    for (std::size_t i : polygon)
      append_little_endian(bytes, std::int32_t(i));
    for (std::uint8_t channel : segment_color(labels[f]))
      append_little_endian(bytes, channel);
    append_little_endian(bytes, std::int32_t(labels[f]));
  }
  out.write(bytes.data(), std::streamsize(bytes.size()));
}

void write_off(std::ostream& out, const Result& result)
{
  const Polygon_soup& soup = result.input.soup;
  Text_buffer text(out);
  text << "OFF\n" << soup.points.size() << " " << soup.polygons.size() << " 0\n";
  for (const Point& p : soup.points)
    write_point(text, p);
  const std::vector<std::size_t> labels = labels_of_faces(result.input, result.segmentation);
  for (std::size_t f = 0; f < labels.size(); ++f) {
    text << soup.polygons[f].size();
    for (std::size_t i : soup.polygons[f])
      text << " " << i;
    for (std::uint8_t channel : segment_color(labels[f]))
      text << " " << int(channel);
    text << "\n";
  }
}

void write_obj(std::ostream& out, const Result& result)
{
  const Polygon_soup& soup = result.input.soup;
  Text_buffer text(out);
  for (const Point& p : soup.points) {
    text << "v ";
    write_point(text, p);
  }
  const std::vector<std::size_t> labels = labels_of_faces(result.input, result.segmentation);
  for (std::size_t f = 0; f < labels.size(); ++f) {
    if (f == 0 || labels[f] != labels[f - 1])
      text << "g segment_" << labels[f] << "\n";
    text << "f";
    for (std::size_t i : soup.polygons[f])
      text << " " << i + 1;
    text << "\n";
  }
  if (!result.segmentation.feature_lines.empty())
    text << "g feature_lines\n";
  for (const std::vector<std::size_t>& line : result.segmentation.feature_lines) {
    text << "l";
    for (std::size_t i : line)
      text << " " << result.input.point_of_mesh_point[i] + 1;
    text << "\n";
  }
}

void write_view(std::ostream& out, const Result& result)
{
  std::vector<Vertex_pair> edges = edges_of_lines(result.segmentation.feature_lines);
  for (Vertex_pair& e : edges)
    for (std::size_t& point : e)
      point = result.input.point_of_mesh_point[point];
  write_png_view(out, result.input.soup, labels_of_faces(result.input, result.segmentation), edges);
}

} // namespace segment_mesh
