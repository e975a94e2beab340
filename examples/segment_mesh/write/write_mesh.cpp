// SPDX-License-Identifier: GPL-3.0-or-later

// Source of .vtp: "VTK XML Formats",
// https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html

#include "write/write_mesh.h"

#include "read/little_endian.h"
#include "soup/vector_algebra.h"
#include "write/Text_buffer.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ostream>
#include <string>

namespace segment_mesh {

namespace {

std::string name_of_segment(std::size_t segment)
{
  return "segment_" + std::to_string(std::int64_t(segment));
}

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

Polygon_soup extract_faces(const Polygon_soup& soup, const std::vector<std::size_t>& faces)
{
  Polygon_soup part;
  std::vector<std::size_t> used;
  for (std::size_t f : faces) {
    part.polygons.push_back(soup.polygons[f]);
    used.insert(used.end(), soup.polygons[f].begin(), soup.polygons[f].end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (std::size_t i : used)
    part.points.push_back(soup.points[i]);
  part.polygons.renumber(
    [&](std::size_t i) { return std::lower_bound(used.begin(), used.end(), i) - used.begin(); });
  return part;
}

std::vector<Segment_triangles> triangles_of_segments(const Labelled_mesh& mesh)
{
  std::vector<Segment_triangles> result;
  const auto faces = faces_of_segments(mesh.segment_of_face);
  for (std::size_t segment = 0; segment + 1 < faces.size(); ++segment) {
    Polygon_soup part = extract_faces(mesh.soup, faces[segment]);
    Segment_triangles triangles{name_of_segment(segment), segment_color(segment), {}, {}};
    for (const Polygon_soup::Polygon& polygon : part.polygons)
      triangulate_polygon(part.points, polygon, triangles.triangles);
    triangles.triangles.erase(
      std::remove_if(triangles.triangles.begin(), triangles.triangles.end(),
                     [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
      triangles.triangles.end());
    triangles.points = std::move(part.points);
    if (!triangles.triangles.empty())
      result.push_back(std::move(triangles));
  }
  return result;
}

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
  write_points(text, "", mesh.soup.points);
  for (std::size_t f = 0; f < mesh.soup.polygons.size(); ++f) {
    text << mesh.soup.polygons[f].size();
    for (std::size_t i : mesh.soup.polygons[f])
      text << " " << i;
    for (std::uint8_t channel : segment_color(mesh.segment_of_face[f]))
      text << " " << int(channel);
    text << "\n";
  }
}

void write_obj(std::ostream& out, const Labelled_mesh& mesh, const std::string& material_library)
{
  Text_buffer text(out);
  if (!material_library.empty())
    text << "mtllib " << material_library << "\n";
  write_points(text, "v ", mesh.soup.points);
  for (const std::vector<std::size_t>& faces : faces_of_segments(mesh.segment_of_face)) {
    if (faces.empty())
      continue;
    const std::string name = name_of_segment(mesh.segment_of_face[faces.front()]);
    text << "g " << name << "\nusemtl " << name << "\n";
    for (std::size_t f : faces)
      write_element(text, "f", mesh.soup.polygons[f]);
  }
}

void write_mtl(std::ostream& out, const Labelled_mesh& mesh)
{
  Text_buffer text(out);
  for (const std::vector<std::size_t>& faces : faces_of_segments(mesh.segment_of_face)) {
    if (faces.empty())
      continue;
    const std::size_t segment = mesh.segment_of_face[faces.front()];
    text << "newmtl " << name_of_segment(segment) << "\nKd";
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
  file.add("</CellData>");
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
      const std::vector<Point> corners = {segment.points[t[0]], segment.points[t[1]],
                                          segment.points[t[2]]};
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
