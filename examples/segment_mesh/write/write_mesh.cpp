// SPDX-License-Identifier: GPL-3.0-or-later

// Source of .vtp: "VTK XML Formats",
// https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html

#include "write/write_mesh.h"

#include "read/errors.h"
#include "read/little_endian.h"
#include "soup/vector_algebra.h"
#include "write/Text_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <string>
#include <utility>

namespace segment_mesh {

namespace {

void write_points(Text_buffer& text, const std::string& start, const std::vector<Point>& points)
{
  for (const Point& p : points)
    text << start << p[0] << " " << p[1] << " " << p[2] << "\n";
}

/// Indices of points, from 1 on.
template <typename Indices>
void write_element(Text_buffer& text, const std::string& name, const Indices& points)
{
  text << name;
  for (std::size_t i : points)
    text << " " << i + 1;
  text << "\n";
}

void make_unique(std::vector<std::size_t>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

std::size_t place_of(std::size_t number, const std::vector<std::size_t>& sorted)
{
  return std::size_t(std::lower_bound(sorted.begin(), sorted.end(), number) - sorted.begin());
}

/// With a blank between two; `start` before the first one.
template <typename Numbers>
void write_numbers(Text_buffer& text, const char* start, const Numbers& numbers)
{
  const char* separator = start;
  for (const auto number : numbers) {
    if constexpr (sizeof(number) == 1)
      text << separator << std::int64_t(number);
    else
      text << separator << number;
    separator = " ";
  }
}

bool has_large_face(const Polygon_soup& soup)
{
  return std::any_of(soup.polygons.begin(), soup.polygons.end(),
                     [](const Polygon_soup::Polygon& polygon) { return polygon.size() > 255; });
}

/// The kinds of sets that there are.
std::vector<Set_kind> kinds_of_sets(const Mesh_properties& properties)
{
  std::vector<Set_kind> kinds;
  for (Set_kind kind : {Set_kind::GROUPS, Set_kind::MATERIALS, Set_kind::SOLIDS})
    if (!properties.of(kind).empty())
      kinds.push_back(kind);
  return kinds;
}

/// "group", "material", "solid".
std::string singular(Set_kind kind)
{
  const std::string name = set_kind_names[std::size_t(kind)];
  return name.substr(0, name.size() - 1);
}

/// From 0 to 255.
Color bytes_of(const Mesh_properties::Rgb& color)
{
  Color bytes;
  std::transform(color.begin(), color.end(), bytes.begin(), [](float channel) {
    return std::uint8_t(std::lround(255 * (std::max)(0.f, (std::min)(channel, 1.f))));
  });
  return bytes;
}

std::string ply_header(const Labelled_mesh& mesh)
{
  const Mesh_properties& properties = mesh.properties;
  const std::string color = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  std::string comments, sets;
  for (Set_kind kind : kinds_of_sets(properties)) {
    const std::vector<std::string>& names = properties.of(kind).names;
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
         "property int segment\n" + sets +
         (properties.texture_corners.empty() ? "" : "property list uint float texcoord\n") +
         "end_header\n";
}

/// The group and the material of a face of .obj, as statements.
std::string obj_statements(const Labelled_mesh& mesh, std::size_t face)
{
  const Mesh_properties& properties = mesh.properties;
  const std::string segment = mesh.name(mesh.segment_of_face[face]);
  const auto name = [&](Set_kind kind) {
    const Face_sets& sets = properties.of(kind);
    return sets.empty() ? "" : sets.names[sets.set_of_face[face]];
  };
  std::string group = segment;
  for (Set_kind kind : {Set_kind::GROUPS, Set_kind::SOLIDS})
    if (const std::string other = clean_name(name(kind)); !other.empty() && other != segment)
      group += " " + other;
  const std::string material = has_obj_materials(properties) ? name(Set_kind::MATERIALS) : segment;
  return "g " + group + "\nusemtl " + one_line(material) + "\n";
}

/// Indices of points, from 1 on, with those of texture points where there are some.
void write_obj_face(Text_buffer& text, const Labelled_mesh& mesh, std::size_t face)
{
  const std::vector<Polygons::Index>& texture = mesh.properties.texture_corners;
  const Polygon_soup::Polygon& polygon = mesh.soup.polygons[face];
  const std::size_t first = std::size_t(polygon.begin() - mesh.soup.polygons.corners().data());
  text << "f";
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    text << " " << polygon[i] + 1;
    if (!texture.empty() && texture[first + i] != Mesh_properties::no_texture)
      text << "/" << texture[first + i] + 1;
  }
  text << "\n";
}

/// PolyData of VTK as XML with arrays of text.
class Vtp_file
{
public:
  Vtp_file(std::ostream& out, std::size_t number_of_points, std::size_t number_of_lines,
           std::size_t number_of_polygons)
    : m_text(out)
  {
    m_text << "<VTKFile type=\"PolyData\" version=\"1.0\">\n<PolyData>\n<Piece NumberOfPoints=\""
           << number_of_points << "\" NumberOfVerts=\"0\" NumberOfLines=\"" << number_of_lines
           << "\" NumberOfStrips=\"0\" NumberOfPolys=\"" << number_of_polygons << "\">\n";
  }
  ~Vtp_file() { m_text << "</Piece>\n</PolyData>\n</VTKFile>\n"; }

  /// The text of what is between the arrays.
  void add(const std::string& text) { m_text << text << "\n"; }

  /// Of `values(element)` for each element, a range of numbers, all of the same size.
  template <typename Elements, typename Values>
  void add(const char* type, const char* name, std::size_t size, const Elements& elements,
           const Values& values)
  {
    m_text << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
           << size << "\" format=\"ascii\">\n";
    for (const auto& element : elements) {
      for (const auto value : values(element))
        m_text << value << " ";
      m_text << "\n";
    }
    m_text << "</DataArray>\n";
  }

  void add_points(const std::vector<Point>& points)
  {
    add("<Points>");
    add("Float64", "Points", 3, points, [](const Point& p) { return p; });
    add("</Points>");
  }

  /// `points(cell)` are the indices of the points of a cell.
  template <typename Cells, typename Points>
  void add_cells(const Cells& cells, const Points& points)
  {
    std::size_t end = 0;
    add("Int64", "connectivity", 1, cells, points);
    add("Int64", "offsets", 1, cells,
        [&](const auto& cell) { return std::array{end += points(cell).size()}; });
  }

private:
  Text_buffer m_text;
};

/// Borders with no other points than theirs.
struct Compact_borders
{
  std::vector<Point> points;
  std::vector<Border> borders;
};

Compact_borders compact(const std::vector<Point>& points, const std::vector<Border>& borders)
{
  constexpr std::size_t unused = std::size_t(-1);
  std::vector<std::size_t> new_index(points.size(), unused);
  Compact_borders result{{}, borders};
  for (Border& border : result.borders)
    for (std::size_t& i : border.points) {
      if (new_index[i] == unused) {
        new_index[i] = result.points.size();
        result.points.push_back(points[i]);
      }
      i = new_index[i];
    }
  return result;
}

} // namespace

Mesh_properties::Texture_point texture_point(const Mesh_properties& properties, std::size_t corner)
{
  const Polygons::Index i = properties.texture_corners[corner];
  return i == Mesh_properties::no_texture ? Mesh_properties::Texture_point{0, 0}
                                          : properties.texture_points[i];
}

std::string relative_name(const std::string& from, const std::string& name, const std::string& to)
{
  namespace fs = std::filesystem;
  return fs::absolute(fs::path(from) / name)
    .lexically_proximate(fs::absolute(fs::path(to) / "."))
    .generic_string();
}

bool has_obj_materials(const Mesh_properties& properties)
{
  return properties.library && !properties.library->files.empty() &&
         !properties.of(Set_kind::MATERIALS).empty();
}

std::vector<std::vector<std::size_t>>
faces_of_segments(const std::vector<std::size_t>& segment_of_face)
{
  std::size_t number_of_segments = 0;
  for (std::size_t label : segment_of_face)
    number_of_segments = (std::max)(number_of_segments, label + 1); // no_segment and 1 are 0
  std::vector<std::vector<std::size_t>> faces(number_of_segments + 1);
  for (std::size_t f = 0; f < segment_of_face.size(); ++f)
    faces[(std::min)(segment_of_face[f], number_of_segments)].push_back(f);
  return faces;
}

Mesh_part extract_faces(const Labelled_mesh& mesh, const std::vector<std::size_t>& faces)
{
  const Mesh_properties& properties = mesh.properties;
  Mesh_part part;
  part.properties.library = properties.library;
  std::vector<std::size_t> points, texture_points;
  for (std::size_t f : faces) {
    const Polygon_soup::Polygon& polygon = mesh.soup.polygons[f];
    part.soup.polygons.push_back(polygon);
    points.insert(points.end(), polygon.begin(), polygon.end());
    const std::size_t first = std::size_t(polygon.begin() - mesh.soup.polygons.corners().data());
    if (!properties.texture_corners.empty())
      for (std::size_t i = first; i < first + polygon.size(); ++i)
        part.properties.texture_corners.push_back(properties.texture_corners[i]);
  }
  for (Set_kind kind : kinds_of_sets(properties)) {
    part.properties.of(kind).names = properties.of(kind).names;
    for (std::size_t f : faces)
      part.properties.of(kind).set_of_face.push_back(properties.of(kind).set_of_face[f]);
  }
  make_unique(points);
  for (std::size_t i : points) {
    part.soup.points.push_back(mesh.soup.points[i]);
    if (!properties.colors.empty())
      part.properties.colors.push_back(properties.colors[i]);
  }
  part.soup.polygons.renumber([&](std::size_t i) { return place_of(i, points); });
  for (Polygons::Index i : part.properties.texture_corners)
    if (i != Mesh_properties::no_texture)
      texture_points.push_back(i);
  make_unique(texture_points);
  for (std::size_t i : texture_points)
    part.properties.texture_points.push_back(properties.texture_points[i]);
  for (Polygons::Index& i : part.properties.texture_corners)
    if (i != Mesh_properties::no_texture)
      i = Polygons::Index(place_of(i, texture_points));
  return part;
}

void add_triangles(const Polygon_soup& soup, const Polygon_soup::Polygon& polygon,
                   Triangles& triangles)
{
  const auto first = std::ptrdiff_t(triangles.size());
  triangulate_polygon(soup.points, polygon, triangles);
  triangles.erase(
    std::remove_if(triangles.begin() + first, triangles.end(),
                   [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
    triangles.end());
}

std::vector<Segment_triangles> triangles_of_segments(const Labelled_mesh& mesh)
{
  std::vector<Segment_triangles> result;
  const auto faces = faces_of_segments(mesh.segment_of_face);
  for (std::size_t segment = 0; segment + 1 < faces.size(); ++segment) {
    Segment_triangles triangles{
      mesh.name(segment), segment_color(segment), extract_faces(mesh, faces[segment]), {}, {}};
    const Polygon_soup& soup = triangles.part.soup;
    for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
      add_triangles(soup, soup.polygons[f], triangles.triangles);
      triangles.face_of_triangle.resize(triangles.triangles.size(), f);
    }
    if (!triangles.triangles.empty())
      result.push_back(std::move(triangles));
  }
  return result;
}

void write_ply(std::ostream& out, const Labelled_mesh& mesh)
{
  const Mesh_properties& properties = mesh.properties;
  const std::vector<Set_kind> kinds = kinds_of_sets(properties);
  const bool has_wide_sizes = has_large_face(mesh.soup);
  std::string bytes = ply_header(mesh);
  const auto append_color = [&bytes](const Color& color) {
    for (std::uint8_t channel : color)
      append_little_endian(bytes, channel);
  };
  for (std::size_t i = 0; i < mesh.soup.points.size(); ++i) {
    for (double coordinate : mesh.soup.points[i])
      append_little_endian(bytes, coordinate);
    if (!properties.colors.empty())
      append_color(bytes_of(properties.colors[i]));
  }
  std::size_t corner = 0;
  for (std::size_t f = 0; f < mesh.soup.polygons.size(); ++f) {
    const Polygon_soup::Polygon& polygon = mesh.soup.polygons[f];
    if (has_wide_sizes)
      append_little_endian(bytes, std::uint32_t(polygon.size()));
    else
      append_little_endian(bytes, std::uint8_t(polygon.size()));
    for (std::size_t i : polygon)
      append_little_endian(bytes, std::int32_t(i));
    append_color(segment_color(mesh.segment_of_face[f]));
    append_little_endian(bytes, std::int32_t(mesh.segment_of_face[f]));
    for (Set_kind kind : kinds)
      append_little_endian(bytes, std::int32_t(properties.of(kind).set_of_face[f]));
    if (properties.texture_corners.empty())
      continue;
    append_little_endian(bytes, std::uint32_t(2 * polygon.size()));
    for (const std::size_t end = corner + polygon.size(); corner < end; ++corner)
      for (double coordinate : texture_point(properties, corner))
        append_little_endian(bytes, float(coordinate));
  }
  out.write(bytes.data(), std::streamsize(bytes.size()));
}

void write_off(std::ostream& out, const Labelled_mesh& mesh)
{
  const std::vector<Mesh_properties::Rgb>& colors = mesh.properties.colors;
  Text_buffer text(out);
  text << (colors.empty() ? "OFF\n" : "COFF\n") << mesh.soup.points.size() << " "
       << mesh.soup.polygons.size() << " 0\n";
  for (std::size_t i = 0; i < mesh.soup.points.size(); ++i) {
    write_numbers(text, "", mesh.soup.points[i]);
    if (!colors.empty()) {
      write_numbers(text, " ", bytes_of(colors[i]));
      text << " 255"; // opaque
    }
    text << "\n";
  }
  for (std::size_t f = 0; f < mesh.soup.polygons.size(); ++f) {
    text << mesh.soup.polygons[f].size();
    write_numbers(text, " ", mesh.soup.polygons[f]);
    write_numbers(text, " ", segment_color(mesh.segment_of_face[f]));
    text << "\n";
  }
}

void write_obj(std::ostream& out, const Labelled_mesh& mesh,
               const std::vector<std::string>& libraries)
{
  const Mesh_properties& properties = mesh.properties;
  Text_buffer text(out);
  for (const std::string& library : libraries)
    text << "mtllib " << library << "\n";
  for (std::size_t i = 0; i < mesh.soup.points.size(); ++i) {
    write_numbers(text, "v ", mesh.soup.points[i]);
    if (!properties.colors.empty())
      write_numbers(text, " ", properties.colors[i]);
    text << "\n";
  }
  for (const Mesh_properties::Texture_point& point : properties.texture_points) {
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

void write_vtp(std::ostream& out, const Labelled_mesh& mesh)
{
  Vtp_file file(out, mesh.soup.points.size(), 0, mesh.soup.polygons.size());
  file.add("<CellData Scalars=\"segment\">");
  file.add("Int32", "segment", 1, mesh.segment_of_face,
           [](std::size_t segment) { return std::array{std::int64_t(segment)}; });
  file.add("UInt8", "color", 3, mesh.segment_of_face, [](std::size_t segment) {
    const Color color = segment_color(segment);
    return std::array<int, 3>{color[0], color[1], color[2]};
  });
  for (Set_kind kind : kinds_of_sets(mesh.properties))
    file.add("Int32", singular(kind).c_str(), 1, mesh.properties.of(kind).set_of_face,
             [](Polygons::Index set) { return std::array{std::int64_t(set)}; });
  file.add("</CellData>");
  if (!mesh.properties.colors.empty()) {
    file.add("<PointData>");
    file.add("UInt8", "point_color", 3, mesh.properties.colors,
             [](const Mesh_properties::Rgb& rgb) {
               const Color color = bytes_of(rgb);
               return std::array<int, 3>{color[0], color[1], color[2]};
             });
    file.add("</PointData>");
  }
  file.add_points(mesh.soup.points);
  file.add("<Polys>");
  file.add_cells(mesh.soup.polygons, [](const Polygon_soup::Polygon& polygon) { return polygon; });
  file.add("</Polys>");
}

void write_stl(std::ostream& out, const Labelled_mesh& mesh)
{
  Text_buffer text(out);
  for (const Segment_triangles& segment : triangles_of_segments(mesh)) {
    text << "solid " << segment.name << "\n";
    for (const auto& t : segment.triangles) {
      const std::vector<Point>& points = segment.part.soup.points;
      const std::vector<Point> corners = {points[t[0]], points[t[1]], points[t[2]]};
      write_points(
        text, "facet normal ",
        {unit_vector(cross_product(minus(corners[1], corners[0]), minus(corners[2], corners[0])))});
      text << "outer loop\n";
      write_points(text, "vertex ", corners);
      text << "endloop\nendfacet\n";
    }
    text << "endsolid " << segment.name << "\n";
  }
}

void write_borders_obj(std::ostream& out, const std::vector<Point>& points,
                       const std::vector<Border>& borders)
{
  const Compact_borders compacted = compact(points, borders);
  Text_buffer text(out);
  write_points(text, "v ", compacted.points);
  for (const Border& border : compacted.borders) {
    text << "g border_" << std::int64_t(border.segments[0]) << "_"
         << std::int64_t(border.segments[1]) << "\n";
    write_element(text, "l", border.points);
  }
}

void write_borders_vtp(std::ostream& out, const std::vector<Point>& points,
                       const std::vector<Border>& borders)
{
  const Compact_borders compacted = compact(points, borders);
  Vtp_file file(out, compacted.points.size(), borders.size(), 0);
  file.add("<CellData Scalars=\"left_segment\">");
  for (std::size_t side : {0, 1})
    file.add(
      "Int32", side == 0 ? "left_segment" : "right_segment", 1, borders,
      [side](const Border& border) { return std::array{std::int64_t(border.segments[side])}; });
  file.add("</CellData>");
  file.add_points(compacted.points);
  file.add("<Lines>");
  file.add_cells(compacted.borders,
                 [](const Border& border) -> const Polyline& { return border.points; });
  file.add("</Lines>");
}

} // namespace segment_mesh
