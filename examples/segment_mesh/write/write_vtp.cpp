// SPDX-License-Identifier: GPL-3.0-or-later

// Source: "VTK XML Formats",
// https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html

#include "write/Text_buffer.h"
#include "write/write_mesh.h"

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace segment_mesh {

namespace {

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

} // namespace

void write_vtp(std::ostream& out, const Labelled_mesh& mesh)
{
  Vtp_file file(out, mesh.soup.points.size(), 0, mesh.soup.polygons.size());
  file.add("<CellData Scalars=\"segment\">");
  file.add("Int32", "segment", 1, mesh.segment_of_face,
           [](std::size_t segment) { return std::array{std::int64_t(segment)}; });
  file.add("UInt8", "color", 3, mesh.segment_of_face, segment_color);
  for (Set_kind kind : mesh.properties.kinds())
    file.add("Int32", singular(kind).c_str(), 1, mesh.properties.of(kind).set_of_face,
             [](Polygons::Index set) { return std::array{std::int64_t(set)}; });
  file.add("</CellData>");
  if (const auto colors = colors_of_points(mesh); !colors.empty()) {
    file.add("<PointData>");
    file.add("UInt8", "point_color", 3, colors, bytes_of);
    file.add("</PointData>");
  }
  file.add_points(mesh.soup.points);
  file.add("<Polys>");
  file.add_cells(mesh.soup.polygons, [](const Polygon_soup::Polygon& polygon) { return polygon; });
  file.add("</Polys>");
}

void write_borders_vtp(std::ostream& out, const std::vector<Point>& points,
                       const std::vector<Border>& borders)
{
  Vtp_file file(out, points.size(), borders.size(), 0);
  file.add("<CellData Scalars=\"left_segment\">");
  for (std::size_t side : {0, 1})
    file.add(
      "Int32", side == 0 ? "left_segment" : "right_segment", 1, borders,
      [side](const Border& border) { return std::array{std::int64_t(border.segments[side])}; });
  file.add("</CellData>");
  file.add_points(points);
  file.add("<Lines>");
  file.add_cells(borders, [](const Border& border) -> const Polyline& { return border.points; });
  file.add("</Lines>");
}

} // namespace segment_mesh
