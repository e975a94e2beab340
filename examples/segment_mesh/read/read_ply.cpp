// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/Ply_binary.h"
#include "read/Ply_header.h"
#include "read/Ply_text.h"
#include "read/read_soup.h"

#include <algorithm>
#include <array>

namespace segment_mesh {

namespace {

/// Reads the data of a file. `Values` knows how values stand in it: `Ply_text` or `Ply_binary`.
template <typename Values>
class Ply_reader
{
public:
  Ply_reader(const Ply_header& header, Values values)
    : m_header(header)
    , m_values(std::move(values))
  {}

  Polygon_soup read(Remarks& remarks)
  {
    for (const Ply_element& element : m_header.elements) {
      reserve(element);
      const bool is_vertex = element.is_vertex();
      for (std::uint64_t item = 0; item < element.count; ++item) {
        m_values.start(element, item);
        Point point{};
        for (const Ply_property& property : element.properties)
          read_property(property, point);
        if (is_vertex)
          m_soup.points.push_back(point);
      }
    }
    if (const std::string rest = m_values.rest(); !rest.empty() && !m_soup.polygons.empty())
      remarks.push_back(rest + ": the header promises " +
                        one_line(items_of(m_header.elements.back())));
    return std::move(m_soup);
  }

private:
  void reserve(const Ply_element& element)
  {
    std::size_t least_size = 0;
    for (const Ply_property& property : element.properties)
      least_size += Values::least_size_of(property.is_list ? property.size_type : property.type);
    if (least_size == 0)
      return;
    const std::size_t size = bounded(element.count, least_size);
    if (element.is_vertex())
      m_soup.points.reserve(m_soup.points.size() + size);
    if (element.is_face())
      m_soup.polygons.reserve(m_soup.polygons.size() + size);
  }

  /// A number of things, as far as the file can hold them.
  std::size_t bounded(std::uint64_t number, std::size_t least_size) const
  {
    return std::size_t((std::min)(number, std::uint64_t(m_values.available() / least_size)));
  }

  void read_property(const Ply_property& property, Point& point)
  {
    const std::int64_t size = property.is_list ? m_values.integer(property.size_type) : 1;
    if (property.role == Ply_role::CORNERS)
      read_face(property.type, size);
    else if (size < 0)
      m_values.fail("a list of " + std::to_string(size) + " values");
    else if (property.role == Ply_role::STRIPS)
      read_strips(property.type, size);
    else if (property.role == Ply_role::NONE)
      m_values.skip(property.type, std::uint64_t(size));
    else
      point[std::size_t(property.role)] = m_values.coordinate(property);
  }

  void read_face(Ply_type type, std::int64_t size)
  {
    if (size < 3)
      m_values.fail("a face with " + std::to_string(size) + " vertices, fewer than 3");
    for (std::int64_t i = 0; i < size; ++i)
      m_soup.polygons.add_corner(checked(m_values.integer(type)));
    m_soup.polygons.close_polygon();
  }

  /// Each point after two makes a triangle with these, whose orientation alternates; -1 ends a
  /// strip. Triangles with a point twice lead from one strip to the next, and are none.
  void read_strips(Ply_type type, std::int64_t size)
  {
    std::size_t a = 0, b = 0, length = 0;
    for (std::int64_t i = 0; i < size; ++i) {
      const std::int64_t index = m_values.integer(type);
      if (index == -1) {
        length = 0;
        continue;
      }
      const std::size_t c = checked(index);
      if (length >= 2 && a != b && b != c && c != a)
        m_soup.polygons.push_back(length % 2 == 0 ? std::array{a, b, c} : std::array{b, a, c});
      a = b;
      b = c;
      ++length;
    }
  }

  std::size_t checked(std::int64_t index) const
  {
    if (index < 0 || std::uint64_t(index) >= m_header.number_of_vertices)
      m_values.fail("index " + std::to_string(index) + " is out of range: there are " +
                    counted(std::size_t(m_header.number_of_vertices), "vertex") + ", from 0");
    return std::size_t(index);
  }

  const Ply_header& m_header;
  Values m_values;
  Polygon_soup m_soup;
};

} // namespace

Polygon_soup read_ply(const std::string& file, std::string_view bytes, Remarks& remarks)
{
  Text_scanner scan(file, bytes, Text_scanner::no_comments);
  const Ply_header header = read_ply_header(file, scan);
  const std::string_view data = bytes.substr(scan.offset_of_next_line());
  Polygon_soup soup = header.format == Ply_format::ASCII
                        ? Ply_reader(header, Ply_text(std::move(scan))).read(remarks)
                        : Ply_reader(header, Ply_binary(file, data, header.format)).read(remarks);
  if (soup.polygons.empty())
    throw Input_error(file, "no faces");
  return soup;
}

} // namespace segment_mesh
