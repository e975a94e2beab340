// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/errors.h"
#include "soup/little_endian.h"
#include "write/write_mesh.h"

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace segment_mesh {

namespace {

bool has_large_face(const Polygon_soup& soup)
{
  return std::any_of(soup.polygons.begin(), soup.polygons.end(),
                     [](const Polygon_soup::Polygon& polygon) { return polygon.size() > 255; });
}

std::string ply_header(const Labelled_mesh& mesh)
{
  const Mesh_properties& properties = mesh.properties;
  const std::string color = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  std::string comments, sets;
  for (Set_kind kind : properties.kinds()) {
    const std::vector<std::string>& names = *properties.of(kind).names;
    for (std::size_t i = 0; i < names.size(); ++i)
      comments += one_line("comment " + singular(kind) + " " + std::to_string(i) + " " + names[i]) +
                  "\n";
    sets += "property int " + singular(kind) + "\n";
  }
  return "ply\nformat binary_little_endian 1.0\n" + comments + "element vertex " +
         std::to_string(mesh.soup.points.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\n" +
         (properties.colors.empty() ? "" : color) + "element face " +
         std::to_string(mesh.soup.polygons.size()) + "\nproperty list " +
         (has_large_face(mesh.soup) ? "uint" : "uchar") + " int vertex_indices\n" + color +
         "property int segment\n" + sets + "end_header\n";
}

void append_color(std::string& bytes, const Color& color)
{
  for (std::uint8_t channel : color)
    append_little_endian(bytes, channel);
}

} // namespace

void write_ply(std::ostream& out, const Labelled_mesh& mesh)
{
  const std::vector<Mesh_properties::Rgb> colors = colors_of_points(mesh);
  const bool has_wide_sizes = has_large_face(mesh.soup);
  std::string bytes = ply_header(mesh);
  for (std::size_t i = 0; i < mesh.soup.points.size(); ++i) {
    for (double coordinate : mesh.soup.points[i])
      append_little_endian(bytes, coordinate);
    if (!colors.empty())
      append_color(bytes, bytes_of(colors[i]));
  }
  for (std::size_t f = 0; f < mesh.soup.polygons.size(); ++f) {
    const Polygon_soup::Polygon& polygon = mesh.soup.polygons[f];
    if (has_wide_sizes)
      append_little_endian(bytes, std::uint32_t(polygon.size()));
    else
      append_little_endian(bytes, std::uint8_t(polygon.size()));
    for (std::size_t i : polygon)
      append_little_endian(bytes, std::int32_t(i));
    append_color(bytes, segment_color(mesh.segment_of_face[f]));
    append_little_endian(bytes, std::int32_t(mesh.segment_of_face[f]));
    for (const Face_sets& sets : mesh.properties.sets)
      if (!sets.empty())
        append_little_endian(bytes, std::int32_t(sets.set_of_face[f]));
  }
  out.write(bytes.data(), std::streamsize(bytes.size()));
}

} // namespace segment_mesh
