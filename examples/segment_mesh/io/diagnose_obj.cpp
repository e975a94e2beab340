// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Text_scanner.h"
#include "io/diagnose_input.h"
#include "io/errors.h"

#include <algorithm>
#include <iterator>

namespace segment_mesh {

namespace {

constexpr std::string_view statements[] = {
  "v",        "vn",   "vt",         "vp",        "f",      "fo",     "l",      "p",     "o",
  "g",        "s",    "mg",         "usemtl",    "mtllib", "usemap", "maplib", "bevel", "c_interp",
  "d_interp", "lod",  "shadow_obj", "trace_obj", "ctech",  "stech",  "cstype", "deg",   "step",
  "bmat",     "curv", "curv2",      "surf",      "parm",   "trim",   "hole",   "scrv",  "sp",
  "end",      "con",  "bsp",        "bzp",       "cdc",    "cdp",    "res",    "call",  "csh"};

/// What is known of an OBJ file while it is read.
class Obj_diagnosis
{
public:
  Obj_diagnosis(const std::string& file, const std::string& bytes)
      : m_file(file), m_scan(file, bytes, '#')
  {
  }

  std::string run()
  {
    while (m_scan.next_line()) {
      const std::string_view statement = m_scan.word();
      if (statement == "v")
        check_vertex();
      else if (statement == "f")
        check_face();
      else if (std::find(std::begin(statements), std::end(statements), statement) ==
               std::end(statements))
        m_scan.fail("unknown statement " + in_quotes(statement));
    }
    if (m_number_of_faces == 0)
      throw Input_error(m_file, "no faces");
    if (m_highest_index > m_number_of_vertices)
      throw Input_error(m_file, m_line_of_highest_index, out_of_range(m_highest_index));
    return std::move(m_output);
  }

private:
  /// The next word, also after a line that a backslash continues.
  std::string_view word()
  {
    std::string_view result = m_scan.word();
    while (result == "\\")
      result = m_scan.next_line() ? m_scan.word() : std::string_view();
    return result;
  }

  void check_vertex()
  {
    m_output += 'v';
    for (int i = 0; i < 3; ++i) {
      const std::string_view coordinate = word();
      if (coordinate.empty())
        m_scan.fail("a vertex with " + std::to_string(i) + " of 3 coordinates");
      m_scan.finite_number(coordinate);
      (m_output += ' ') += coordinate;
    }
    m_output += '\n';
    ++m_number_of_vertices;
  }

  void check_face()
  {
    m_output += 'f';
    int size = 0;
    for (std::string_view corner = word(); !corner.empty(); corner = word(), ++size) {
      const std::string_view digits = corner.substr(0, corner.find('/'));
      check_index(m_scan.integer(digits, "an index of a vertex"));
      (m_output += ' ') += digits;
    }
    if (size < 3)
      m_scan.fail("a face with " + counted(std::size_t(size), "vertex") + ", fewer than 3");
    m_output += '\n';
    ++m_number_of_faces;
  }

  /// Negative indices count back from here; others may be of vertices that are still to come.
  void check_index(std::int64_t index)
  {
    if (index == 0 || index < -m_number_of_vertices)
      m_scan.fail(out_of_range(index));
    if (index > m_highest_index) {
      m_highest_index = index;
      m_line_of_highest_index = m_scan.line_number();
    }
  }

  std::string out_of_range(std::int64_t index) const
  {
    return "index " + std::to_string(index) + " is out of range: there are " +
           counted(std::size_t(m_number_of_vertices), "vertex") + ", from 1";
  }

  std::string m_file;
  Text_scanner m_scan;
  std::string m_output;
  std::int64_t m_number_of_vertices = 0, m_number_of_faces = 0, m_highest_index = 0;
  std::size_t m_line_of_highest_index = 0;
};

} // namespace

// CGAL's reader takes a tab for the end of a face, and does not know all statements: it is given
// vertices and faces alone.
std::string diagnose_obj(const std::string& file, const std::string& bytes)
{
  return Obj_diagnosis(file, bytes).run();
}

} // namespace segment_mesh
