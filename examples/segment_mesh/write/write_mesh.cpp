// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/write_mesh.h"

#include "write/Text_buffer.h"
#include "read/little_endian.h"
#include "view/segment_colors.h"

#include <algorithm>
#include <cstdint>
#include <string>

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

void write_line(Text_buffer& text, const Polyline& line)
{
  text << "l";
  for (std::size_t i : line)
    text << " " << i + 1;
  text << "\n";
}

} // namespace

void write_ply(std::ostream& out, const Labelled_mesh& mesh)
{
  const bool has_wide_sizes = has_large_face(mesh.soup);
  std::string bytes = ply_header(mesh.soup);
  for (const Point& p : mesh.soup.points)
    for (double coordinate : p)
      append_little_endian(bytes, coordinate);
  for (std::size_t f = 0; f < mesh.soup.polygons.size(); ++f) {
    const Polygon_soup::Polygon& polygon = mesh.soup.polygons[f];
    if (has_wide_sizes)
      append_little_endian(bytes, std::uint32_t(polygon.size()));
    else
      append_little_endian(bytes, std::uint8_t(polygon.size()));
    for (std::size_t i : polygon)
      append_little_endian(bytes, std::int32_t(i));
    for (std::uint8_t channel : segment_color(mesh.segment_of_face[f]))
      append_little_endian(bytes, channel);
    append_little_endian(bytes, std::int32_t(mesh.segment_of_face[f]));
  }
  out.write(bytes.data(), std::streamsize(bytes.size()));
}

void write_off(std::ostream& out, const Labelled_mesh& mesh)
{
  Text_buffer text(out);
  text << "OFF\n" << mesh.soup.points.size() << " " << mesh.soup.polygons.size() << " 0\n";
  for (const Point& p : mesh.soup.points)
    write_point(text, p);
  for (std::size_t f = 0; f < mesh.soup.polygons.size(); ++f) {
    text << mesh.soup.polygons[f].size();
    for (std::size_t i : mesh.soup.polygons[f])
      text << " " << i;
    for (std::uint8_t channel : segment_color(mesh.segment_of_face[f]))
      text << " " << int(channel);
    text << "\n";
  }
}

void write_obj(std::ostream& out, const Labelled_mesh& mesh,
               const std::vector<Polyline>& feature_lines)
{
  Text_buffer text(out);
  for (const Point& p : mesh.soup.points) {
    text << "v ";
    write_point(text, p);
  }
  const std::vector<std::size_t>& labels = mesh.segment_of_face;
  for (std::size_t f = 0; f < labels.size(); ++f) {
    if (f == 0 || labels[f] != labels[f - 1])
      text << "g segment_" << std::int64_t(labels[f]) << "\n";
    text << "f";
    for (std::size_t i : mesh.soup.polygons[f])
      text << " " << i + 1;
    text << "\n";
  }
  if (!feature_lines.empty())
    text << "g feature_lines\n";
  for (const Polyline& line : feature_lines)
    write_line(text, line);
}

void write_borders_obj(std::ostream& out, const std::vector<Point>& points,
                       const std::vector<Border>& borders)
{
  Text_buffer text(out);
  constexpr std::size_t unused = std::size_t(-1);
  std::vector<std::size_t> new_index(points.size(), unused);
  std::size_t number_of_used = 0;
  for (const Border& border : borders)
    for (std::size_t i : border.points) {
      if (new_index[i] != unused)
        continue;
      new_index[i] = number_of_used++;
      text << "v ";
      write_point(text, points[i]);
    }
  for (const Border& border : borders) {
    Polyline line;
    for (std::size_t i : border.points)
      line.push_back(new_index[i]);
    text << "g border_" << std::int64_t(border.segments[0]) << "_"
         << std::int64_t(border.segments[1]) << "\n";
    write_line(text, line);
  }
}

} // namespace segment_mesh
