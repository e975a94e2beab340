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
  Vtp_file(std::ostream& out, const Polygon_soup& soup)
    : m_text(out)
  {
    m_text << "<VTKFile type=\"PolyData\" version=\"1.0\">\n<PolyData>\n<Piece NumberOfPoints=\""
           << soup.points.size()
           << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
           << soup.polygons.size() << "\">\n";
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

private:
  Text_buffer m_text;
};

} // namespace

void write_vtp(std::ostream& out, const Labelled_mesh& mesh)
{
  Vtp_file file(out, mesh.soup);
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
  file.add("<Points>");
  file.add("Float64", "Points", 3, mesh.soup.points, [](const Point& p) { return p; });
  file.add("</Points>\n<Polys>");
  std::size_t end = 0;
  file.add("Int64", "connectivity", 1, mesh.soup.polygons, [](const auto& p) { return p; });
  file.add("Int64", "offsets", 1, mesh.soup.polygons,
           [&end](const auto& polygon) { return std::array{end += polygon.size()}; });
  file.add("</Polys>");
}

} // namespace segment_mesh
