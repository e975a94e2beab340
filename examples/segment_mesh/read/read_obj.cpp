// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/Face_set_builder.h"
#include "read/Text_scanner.h"
#include "read/errors.h"
#include "read/read_mesh.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <memory>
#include <utility>

namespace segment_mesh {

namespace {

constexpr std::string_view other_statements[] = {
  "vn",     "vp",       "l",        "p",    "s",          "mg",        "usemap", "maplib",
  "bevel",  "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "ctech",  "stech",
  "cstype", "deg",      "step",     "bmat", "curv",       "curv2",     "surf",   "parm",
  "trim",   "hole",     "scrv",     "sp",   "end",        "con",       "bsp",    "bzp",
  "cdc",    "cdp",      "res",      "call", "csh"};

/// What is known of an OBJ file while it is read.
class Obj_reader
{
public:
  Obj_reader(const std::string& file, std::string_view bytes)
    : m_file(file)
    , m_scan(file, bytes, '#', Text_scanner::Continuation::BACKSLASH)
  {
    m_library.folder = std::filesystem::path(file).parent_path().string();
  }

  Input_mesh read()
  {
    while (m_scan.next_line()) {
      const std::string_view statement = m_scan.word();
      if (is_word(statement, "v"))
        read_point();
      else if (is_word(statement, "f") || is_word(statement, "fo")) // its name in old files
        read_face();
      else if (is_word(statement, "vt"))
        read_texture_point();
      else if (is_word(statement, "g") || is_word(statement, "o"))
        m_groups.start(std::string(m_scan.rest_of_line()), m_soup.polygons.size());
      else if (is_word(statement, "usemtl"))
        m_materials.start(std::string(m_scan.rest_of_line()), m_soup.polygons.size());
      else if (is_word(statement, "mtllib"))
        add_library(std::string(m_scan.rest_of_line()));
      else if (std::none_of(std::begin(other_statements), std::end(other_statements),
                            [=](std::string_view other) { return is_word(statement, other); }))
        keep_unknown(statement);
    }
    if (m_soup.polygons.empty() && m_number_of_unknown > 0)
      throw Input_error(m_file, m_line_of_unknown, "unknown statement " + m_unknown);
    if (m_highest_index > std::int64_t(m_soup.points.size()))
      throw Input_error(m_file, m_line_of_highest_index,
                        out_of_range(m_highest_index, m_soup.points.size(), "vertex", 1));
    if (m_number_of_unknown > 0)
      m_input.remarks.push_back(one_line(
        m_file + ":" + std::to_string(m_line_of_unknown) + ": unknown statement " + m_unknown +
        " skipped" +
        (m_number_of_unknown > 1 ? ", and " + std::to_string(m_number_of_unknown - 1) + " more"
                                 : "")));
    finish_properties();
    return std::move(m_input);
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
    if (m_scan.has_word())
      read_color();
  }

  /// Three more numbers on the line of a point; one or two are others.
  void read_color()
  {
    const std::string_view words[] = {m_scan.word(), m_scan.word(), m_scan.word()};
    if (words[2].empty())
      return;
    auto& colors = m_input.properties.colors.values;
    colors.resize(m_soup.points.size(), Mesh_properties::white);
    for (std::size_t i = 0; i < 3; ++i)
      colors.back()[i] = float(number_or_zero(words[i]));
  }

  void read_texture_point()
  {
    auto& point = m_input.properties.texture.values.emplace_back();
    for (double& coordinate : point) // v is 0 where it is not given
      coordinate = number_or_zero(m_scan.word());
  }

  /// A line with several names is kept as one name, since names may have blanks.
  void add_library(const std::string& name)
  {
    if (std::find(m_library.files.begin(), m_library.files.end(), name) == m_library.files.end())
      m_library.files.push_back(name);
  }

  void read_face()
  {
    m_corners.clear();
    for (std::string_view corner = m_scan.word(); !corner.empty(); corner = m_scan.word()) {
      m_corners.push_back(
        from_zero(m_scan.integer(corner.substr(0, corner.find('/')), "an index of a vertex")));
      if (corner.find('/') != std::string_view::npos)
        add_texture(corner.substr(corner.find('/') + 1));
    }
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
      m_scan.fail(out_of_range(index, m_soup.points.size(), "vertex", 1));
    if (index > m_highest_index) {
      m_highest_index = index;
      m_line_of_highest_index = m_scan.line_number();
    }
    return std::size_t(index < 0 ? number_of_vertices + index : index - 1);
  }

  /// Of the last corner. `word`: its index, as those of points, and what follows it
  void add_texture(std::string_view word)
  {
    auto& texture = m_input.properties.texture;
    const auto size = std::int64_t(texture.values.size());
    std::int64_t index = 0;
    std::from_chars(word.data(), word.data() + word.size(), index);
    index = index < 0 ? size + index : index - 1;
    const std::size_t corner = m_soup.polygons.corners().size() + m_corners.size() - 1;
    texture.of_corner.resize(corner, texture.none);
    texture.of_corner.push_back(
      index >= 0 && index < std::int64_t(texture.none) ? Polygons::Index(index) : texture.none);
  }

  void finish_properties()
  {
    Mesh_properties& properties = m_input.properties;
    properties.texture.of_corner.resize(m_soup.polygons.corners().size(), properties.texture.none);
    if (!properties.colors.values.empty())
      properties.colors.values.resize(m_soup.points.size(), Mesh_properties::white);
    properties.of(Set_kind::GROUPS) = m_groups.build(m_soup.polygons.size());
    properties.of(Set_kind::MATERIALS) = m_materials.build(m_soup.polygons.size());
    if (!m_library.files.empty())
      properties.library = std::make_shared<Material_library>(std::move(m_library));
  }

  std::string m_file;
  Text_scanner m_scan;
  Input_mesh m_input;
  Polygon_soup& m_soup = m_input.soup;
  Face_set_builder m_groups, m_materials;
  Material_library m_library;
  std::vector<std::size_t> m_corners; // of the face that is read
  std::int64_t m_highest_index = 0;
  std::size_t m_line_of_highest_index = 0;
  std::string m_unknown; // the first one, in quotes
  std::size_t m_number_of_unknown = 0, m_line_of_unknown = 0;
};

} // namespace

Input_mesh read_obj(const std::string& file, std::string_view bytes)
{
  return Obj_reader(file, bytes).read();
}

} // namespace segment_mesh
