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

/// Texture coordinates as those of points, or empty if some points have several.
std::vector<Mesh_properties::Texture_point> texture_of_points(const Labelled_mesh& mesh)
{
  const auto& texture = mesh.properties.texture;
  if (texture.empty())
    return {};
  std::vector<Mesh_properties::Texture_point> result = texture.of_points(mesh.soup, {});
  const std::vector<Polygons::Index>& corners = mesh.soup.polygons.corners();
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (texture.at(i, {}) != result[corners[i]])
      return {};
  return result;
}

/// The properties that vertices and faces have.
struct Ply_layout
{
  std::vector<Mesh_properties::Rgb> colors;            // of points
  std::vector<Mesh_properties::Texture_point> texture; // of points
  bool has_wide_sizes, has_texture_of_faces;
};

std::string ply_header(const Labelled_mesh& mesh, const Ply_layout& layout,
                       const std::vector<std::string>& textures)
{
  const Mesh_properties& properties = mesh.properties;
  const std::string color = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  std::string comments, sets;
  for (const std::string& texture : textures)
    comments += one_line("comment TextureFile " + texture) + "\n";
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
         (layout.colors.empty() ? "" : color) +
         (layout.texture.empty() ? "" : "property float s\nproperty float t\n") + "element face " +
         std::to_string(mesh.soup.polygons.size()) + "\nproperty list " +
         (layout.has_wide_sizes ? "uint" : "uchar") + " int vertex_indices\n" + color +
         "property int segment\n" + sets +
         (layout.has_texture_of_faces ? "property list uint float texcoord\n" : "") +
         "end_header\n";
}

void append_color(std::string& bytes, const Color& color)
{
  for (std::uint8_t channel : color)
    append_little_endian(bytes, channel);
}

void append_point(std::string& bytes, const Mesh_properties::Texture_point& point)
{
  for (double coordinate : point)
    append_little_endian(bytes, float(coordinate));
}

} // namespace

void write_ply(std::ostream& out, const Labelled_mesh& mesh,
               const std::vector<std::string>& textures)
{
  const Mesh_properties& properties = mesh.properties;
  Ply_layout layout = {colors_of_points(mesh), texture_of_points(mesh), has_large_face(mesh.soup),
                       false};
  layout.has_texture_of_faces = !properties.texture.empty() && layout.texture.empty();
  std::string bytes = ply_header(mesh, layout, textures);
  for (std::size_t i = 0; i < mesh.soup.points.size(); ++i) {
    for (double coordinate : mesh.soup.points[i])
      append_little_endian(bytes, coordinate);
    if (!layout.colors.empty())
      append_color(bytes, bytes_of(layout.colors[i]));
    if (!layout.texture.empty())
      append_point(bytes, layout.texture[i]);
  }
  for (std::size_t f = 0, corner = 0; f < mesh.soup.polygons.size(); ++f) {
    const Polygon_soup::Polygon& polygon = mesh.soup.polygons[f];
    if (layout.has_wide_sizes)
      append_little_endian(bytes, std::uint32_t(polygon.size()));
    else
      append_little_endian(bytes, std::uint8_t(polygon.size()));
    for (std::size_t i : polygon)
      append_little_endian(bytes, std::int32_t(i));
    append_color(bytes, segment_color(mesh.segment_of_face[f]));
    append_little_endian(bytes, std::int32_t(mesh.segment_of_face[f]));
    for (const Face_sets& sets : properties.sets)
      if (!sets.empty())
        append_little_endian(bytes, std::int32_t(sets.set_of_face[f]));
    if (!layout.has_texture_of_faces)
      continue;
    append_little_endian(bytes, std::uint32_t(2 * polygon.size()));
    for (const std::size_t end = corner + polygon.size(); corner < end; ++corner)
      append_point(bytes, properties.texture.at(corner, {}));
  }
  out.write(bytes.data(), std::streamsize(bytes.size()));
}

} // namespace segment_mesh
