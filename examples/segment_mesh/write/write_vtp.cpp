// SPDX-License-Identifier: GPL-3.0-or-later

// PolyData of VTK as an XML file with appended raw data: each array is its size in bytes, then its
// values. Source: "VTK XML Formats",
// https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html

#include "read/little_endian.h"
#include "write/write_mesh.h"
#include "view/segment_colors.h"

#include <cstdint>
#include <ostream>
#include <string>
#include <type_traits>

namespace segment_mesh {

namespace {

class Vtp_file
{
public:
  Vtp_file(std::size_t number_of_points, std::size_t number_of_lines,
           std::size_t number_of_polygons)
  {
    m_xml = "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
            "header_type=\"UInt64\">\n"
            "<PolyData>\n<Piece NumberOfPoints=\"" +
            std::to_string(number_of_points) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
            std::to_string(number_of_lines) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
            std::to_string(number_of_polygons) + "\">\n";
  }

  void open(const std::string& element) { m_xml += "<" + element + ">\n"; }
  void close(const std::string& element) { m_xml += "</" + element + ">\n"; }

  /// Adds an array; `append(values)` appends its values to a string.
  template <typename Value, typename Append>
  void add(const std::string& name, std::size_t number_of_components, Append append)
  {
    m_xml += "<DataArray type=\"" + type_name<Value>() + "\" Name=\"" + name +
             "\" NumberOfComponents=\"" + std::to_string(number_of_components) +
             "\" format=\"appended\" offset=\"" + std::to_string(m_data.size()) + "\"/>\n";
    std::string values;
    append(values);
    append_little_endian(m_data, std::uint64_t(values.size()));
    m_data += values;
  }

  void add_points(const std::vector<Point>& points)
  {
    open("Points");
    add<double>("Points", 3, [&](std::string& values) {
      for (const Point& p : points)
        for (double x : p)
          append_little_endian(values, x);
    });
    close("Points");
  }

  /// `cell_points(c)` are the indices of the points of a cell.
  template <typename Cells, typename CellPoints>
  void add_cells(const std::string& element, const Cells& cells, CellPoints cell_points)
  {
    open(element);
    add<std::int64_t>("connectivity", 1, [&](std::string& values) {
      for (const auto& cell : cells)
        for (std::size_t i : cell_points(cell))
          append_little_endian(values, std::int64_t(i));
    });
    add<std::int64_t>("offsets", 1, [&](std::string& values) {
      std::int64_t end = 0;
      for (const auto& cell : cells)
        append_little_endian(values, end += std::int64_t(cell_points(cell).size()));
    });
    close(element);
  }

  void write(std::ostream& out) const
  {
    out << m_xml << "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
    out.write(m_data.data(), std::streamsize(m_data.size()));
    out << "\n</AppendedData>\n</VTKFile>\n";
  }

private:
  template <typename Value>
  static std::string type_name()
  {
    if (std::is_same<Value, double>::value)
      return "Float64";
    return (std::is_signed<Value>::value ? "Int" : "UInt") + std::to_string(8 * sizeof(Value));
  }

  std::string m_xml, m_data;
};

const std::vector<std::size_t>& points_of_border(const Border& border)
{
  return border.points;
}

} // namespace

void write_vtp(std::ostream& out, const Labelled_mesh& mesh)
{
  Vtp_file file(mesh.soup.points.size(), 0, mesh.soup.polygons.size());
  file.open("CellData Scalars=\"segment\"");
  file.add<std::int32_t>("segment", 1, [&](std::string& values) {
    for (std::size_t segment : mesh.segment_of_face)
      append_little_endian(values, std::int32_t(segment));
  });
  file.add<std::uint8_t>("color", 3, [&](std::string& values) {
    for (std::size_t segment : mesh.segment_of_face)
      for (std::uint8_t channel : segment_color(segment))
        append_little_endian(values, channel);
  });
  file.close("CellData");
  file.add_points(mesh.soup.points);
  file.add_cells(
    "Polys", mesh.soup.polygons,
    [](const Polygon_soup::Polygon& polygon) -> const Polygon_soup::Polygon& { return polygon; });
  file.write(out);
}

void write_borders_vtp(std::ostream& out, const std::vector<Point>& points,
                       const std::vector<Border>& borders)
{
  Vtp_file file(points.size(), borders.size(), 0);
  file.open("CellData Scalars=\"left_segment\"");
  for (std::size_t side : {0, 1})
    file.add<std::int32_t>(side == 0 ? "left_segment" : "right_segment", 1,
                           [&](std::string& values) {
                             for (const Border& border : borders)
                               append_little_endian(values, std::int32_t(border.segments[side]));
                           });
  file.close("CellData");
  file.add_points(points);
  file.add_cells("Lines", borders, points_of_border);
  file.write(out);
}

} // namespace segment_mesh
