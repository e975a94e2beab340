// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/Text_scanner.h"
#include "read/errors.h"
#include "read/read_mesh.h"

#include <algorithm>
#include <iterator>

namespace segment_mesh {

namespace {

constexpr std::string_view other_statements[] = {
  "vn",         "vt",        "vp",     "fo",     "l",      "p",     "o",        "g",        "s",
  "mg",         "usemtl",    "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp", "lod",
  "shadow_obj", "trace_obj", "ctech",  "stech",  "cstype", "deg",   "step",     "bmat",     "curv",
  "curv2",      "surf",      "parm",   "trim",   "hole",   "scrv",  "sp",       "end",      "con",
  "bsp",        "bzp",       "cdc",    "cdp",    "res",    "call",  "csh"};

/// What is known of an OBJ file while it is read.
class Obj_reader
{
public:
  Obj_reader(const std::string& file, std::string_view bytes)
    : m_file(file)
    , m_scan(file, bytes, '#', Text_scanner::Continuation::BACKSLASH)
  {}

  Polygon_soup read(Remarks& remarks)
  {
    while (m_scan.next_line()) {
      const std::string_view statement = m_scan.word();
      if (is_word(statement, "v"))
        read_point();
      else if (is_word(statement, "f"))
        read_face();
      else if (std::none_of(std::begin(other_statements), std::end(other_statements),
                            [=](std::string_view other) { return is_word(statement, other); }))
        keep_unknown(statement);
    }
    if (m_soup.polygons.empty() && m_number_of_unknown > 0)
      throw Input_error(m_file, m_line_of_unknown, "unknown statement " + m_unknown);
    if (m_highest_index > std::int64_t(m_soup.points.size()))
      throw Input_error(m_file, m_line_of_highest_index, out_of_range(m_highest_index));
    if (m_number_of_unknown > 0)
      remarks.push_back(one_line(m_file + ":" + std::to_string(m_line_of_unknown) +
                                 ": unknown statement " + m_unknown + " skipped" +
                                 (m_number_of_unknown > 1
                                    ? ", and " + std::to_string(m_number_of_unknown - 1) + " more"
                                    : "")));
    return std::move(m_soup);
  }

private:
  void keep_unknown(std::string_view statement)
  {
    if (m_number_of_unknown++ > 0)
      return;
    m_unknown = in_quotes(statement);
    m_line_of_unknown = m_scan.line_number();
  }

  void read_point()
  {
    Point& point = m_soup.points.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string_view coordinate = m_scan.word();
      if (coordinate.empty())
        m_scan.fail("a vertex with " + std::to_string(i) + " of 3 coordinates");
      point[i] = m_scan.finite_number(coordinate);
    }
  }

  void read_face()
  {
    m_corners.clear();
    for (std::string_view corner = m_scan.word(); !corner.empty(); corner = m_scan.word())
      m_corners.push_back(
        from_zero(m_scan.integer(corner.substr(0, corner.find('/')), "an index of a vertex")));
    if (m_corners.size() < 3)
      m_scan.fail("a face with " + counted(m_corners.size(), "vertex") + ", fewer than 3");
    m_soup.polygons.push_back(m_corners);
  }

  /// Negative indices count back from here; others, from 1, may be of vertices that are still to
  /// come.
  std::size_t from_zero(std::int64_t index)
  {
    const std::int64_t number_of_vertices = std::int64_t(m_soup.points.size());
    if (index == 0 || index < -number_of_vertices)
      m_scan.fail(out_of_range(index));
    if (index > m_highest_index) {
      m_highest_index = index;
      m_line_of_highest_index = m_scan.line_number();
    }
    return std::size_t(index < 0 ? number_of_vertices + index : index - 1);
  }

  std::string out_of_range(std::int64_t index) const
  {
    return "index " + std::to_string(index) + " is out of range: there are " +
           counted(m_soup.points.size(), "vertex") + ", from 1";
  }

  std::string m_file;
  Text_scanner m_scan;
  Polygon_soup m_soup;
  std::vector<std::size_t> m_corners; // of the face that is read
  std::int64_t m_highest_index = 0;
  std::size_t m_line_of_highest_index = 0;
  std::string m_unknown; // the first one, in quotes
  std::size_t m_number_of_unknown = 0, m_line_of_unknown = 0;
};

} // namespace

Polygon_soup read_obj(const std::string& file, std::string_view bytes, Remarks& remarks)
{
  return Obj_reader(file, bytes).read(remarks);
}

} // namespace segment_mesh
