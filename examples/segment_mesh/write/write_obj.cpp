// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/errors.h"
#include "write/Text_buffer.h"
#include "write/write_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

namespace {

/// The group and the material of a face of .obj, as statements.
std::string obj_statements(const Labelled_mesh& mesh, std::size_t face)
{
  const Mesh_properties& properties = mesh.properties;
  const std::string segment = mesh.name(mesh.segment_of_face[face]);
  std::string group = segment;
  for (Set_kind kind : properties.kinds()) {
    std::string name = properties.of(kind).name(face);
    std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c <= ' '; }, '_');
    if (name != segment && !(kind == Set_kind::MATERIALS && has_obj_materials(properties)))
      group += " " + name;
  }
  const std::string material = has_obj_materials(properties)
                                 ? properties.of(Set_kind::MATERIALS).name(face)
                                 : segment;
  return "g " + group + "\nusemtl " + one_line(material) + "\n";
}

/// Indices of points, from 1 on, with those of texture points where there are some.
void write_obj_face(Text_buffer& text, const Labelled_mesh& mesh, std::size_t face)
{
  const auto& texture = mesh.properties.texture;
  const Polygon_soup::Polygon& polygon = mesh.soup.polygons[face];
  const std::size_t first = mesh.soup.polygons.first_corner(face);
  text << "f";
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    text << " " << polygon[i] + 1;
    if (!texture.empty() && texture.of_corner[first + i] != texture.none)
      text << "/" << texture.of_corner[first + i] + 1;
  }
  text << "\n";
}

} // namespace

bool has_obj_materials(const Mesh_properties& properties)
{
  return properties.library && !properties.library->files.empty() &&
         !properties.of(Set_kind::MATERIALS).empty();
}

void write_obj(std::ostream& out, const Labelled_mesh& mesh,
               const std::vector<std::string>& libraries)
{
  const Mesh_properties& properties = mesh.properties;
  Text_buffer text(out);
  for (const std::string& library : libraries)
    text << "mtllib " << library << "\n";
  const std::vector<Mesh_properties::Rgb> colors = colors_of_points(mesh);
  for (std::size_t i = 0; i < mesh.soup.points.size(); ++i) {
    write_numbers(text, "v ", mesh.soup.points[i]);
    if (!colors.empty())
      write_numbers(text, " ", colors[i]);
    text << "\n";
  }
  for (const Mesh_properties::Texture_point& point : properties.texture.values) {
    write_numbers(text, "vt ", point);
    text << "\n";
  }
  std::array<std::size_t, 4> last; // the segment and the sets of the last face
  last.fill(std::size_t(-2));      // none
  for (const std::vector<std::size_t>& faces : faces_of_segments(mesh.segment_of_face))
    for (std::size_t f : faces) {
      std::array<std::size_t, 4> here = {mesh.segment_of_face[f]};
      for (std::size_t kind = 0; kind < 3; ++kind)
        if (!properties.sets[kind].empty())
          here[1 + kind] = properties.sets[kind].set_of_face[f];
      if (here != std::exchange(last, here))
        text << obj_statements(mesh, f);
      write_obj_face(text, mesh, f);
    }
}

void write_mtl(std::ostream& out, const Labelled_mesh& mesh)
{
  Text_buffer text(out);
  for (const std::vector<std::size_t>& faces : faces_of_segments(mesh.segment_of_face)) {
    if (faces.empty())
      continue;
    const std::size_t segment = mesh.segment_of_face[faces.front()];
    text << "newmtl " << mesh.name(segment) << "\nKd";
    for (std::uint8_t channel : segment_color(segment))
      text << " " << float(channel) / 255;
    text << "\n";
  }
}

void write_borders_obj(std::ostream& out, const std::vector<Point>& points,
                       const std::vector<Border>& borders)
{
  Text_buffer text(out);
  for (const Point& p : points) {
    write_numbers(text, "v ", p);
    text << "\n";
  }
  for (const Border& border : borders) {
    text << "g border_" << std::int64_t(border.segments[0]) << "_"
         << std::int64_t(border.segments[1]) << "\nl";
    for (std::size_t i : border.points)
      text << " " << i + 1;
    text << "\n";
  }
}

} // namespace segment_mesh
