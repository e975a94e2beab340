// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/Face_set_builder.h"
#include "read/Text_scanner.h"
#include "read/errors.h"
#include "soup/little_endian.h"
#include "read/read_mesh.h"
#include "soup/vector_algebra.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace segment_mesh {

namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t data_offset = header_size + 4;
constexpr std::size_t normal_size = 12;
constexpr std::size_t triangle_size = 50; // a normal and 3 points as floats, 2 bytes of attributes

std::size_t promised_triangles(std::string_view bytes)
{
  return bytes.size() < data_offset ? 0 : read_bytes<std::uint32_t>(&bytes[header_size]);
}

bool has_size_of_binary(std::string_view bytes)
{
  return bytes.size() == data_offset + triangle_size * promised_triangles(bytes);
}

/// Binary files whose header starts with "solid" do exist.
bool is_text(std::string_view bytes)
{
  const std::string_view text = without_byte_order_mark(bytes);
  const std::size_t start = (std::min)(text.find_first_not_of(" \t\r\n"), text.size());
  return !has_size_of_binary(bytes) && is_word(text.substr(start, 5), "solid") &&
         text.find('\0') == std::string_view::npos;
}

/// The triangles as polygons on three points each.
Polygon_soup triangles_on(std::vector<Point> points)
{
  Polygon_soup soup;
  soup.polygons.reserve(points.size() / 3);
  for (std::size_t i = 0; i + 2 < points.size(); i += 3)
    soup.polygons.push_back({i, i + 1, i + 2});
  soup.points = std::move(points);
  return soup;
}

Input_mesh read_binary(const std::string& file, std::string_view bytes)
{
  if (!has_size_of_binary(bytes))
    check_encoding(file, bytes);
  if (bytes.size() < data_offset)
    throw Input_error(file,
                      "neither a text that starts with 'solid' nor long enough for a binary STL");
  const std::size_t promised = promised_triangles(bytes);
  const std::size_t available = (bytes.size() - data_offset) / triangle_size;
  if (promised > available)
    throw Input_error(file, "the header promises " + counted(promised, "triangle") +
                              ", the file ends after " + std::to_string(available) +
                              ": no whole binary STL, and no text that starts with 'solid'");
  Input_mesh input;
  if (const std::size_t rest = bytes.size() - data_offset - triangle_size * promised; rest > 0)
    input.remarks.push_back(bytes_not_read(file, rest) + " at the end: the header promises " +
                            counted(promised, "triangle"));
  std::vector<Point> points;
  points.reserve(3 * promised);
  for (std::size_t i = 0; i < promised; ++i)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const char* const
        at = &bytes[data_offset + triangle_size * i + normal_size + 3 * sizeof(float) * corner];
      Point& point = points.emplace_back();
      for (std::size_t j = 0; j < 3; ++j)
        point[j] = read_bytes<float>(at + sizeof(float) * j);
      if (!is_finite(point))
        throw Input_error(file, "triangle " + std::to_string(i) +
                                  ", from 0, has a coordinate that is not a finite number");
    }
  input.soup = triangles_on(std::move(points));
  return input;
}

/// The rest of a facet, after its first word. The normal, and the numbers of colors, are skipped.
void read_facet(Text_scanner& scan, std::vector<Point>& points)
{
  const auto due_word = [&scan] {
    const std::string_view word = scan.word_of_any_line();
    if (word.empty())
      scan.fail("the file ends within a facet");
    return word;
  };
  std::size_t size = 0;
  for (std::string_view previous, word = due_word();
       !is_word(word, "endfacet") && !(is_word(previous, "end") && is_word(word, "facet"));
       previous = word, word = due_word()) {
    constexpr std::string_view others[] = {"normal", "outer", "loop", "endloop", "end", "color"};
    if (is_word(word, "normal"))
      for (int i = 0; i < 3; ++i) // which may be nan
        due_word();
    else if (!is_word(word, "vertex") && std::isalpha(static_cast<unsigned char>(word.front())) &&
             std::none_of(std::begin(others), std::end(others),
                          [=](std::string_view other) { return is_word(word, other); }))
      scan.fail(in_quotes(word) + " within a facet");
    if (!is_word(word, "vertex"))
      continue;
    if (++size > 3)
      scan.fail("a facet with more than 3 vertices");
    Point& point = points.emplace_back();
    for (double& coordinate : point)
      coordinate = scan.finite_number(due_word());
  }
  if (size < 3)
    scan.fail("a face with " + counted(size, "vertex") + ", fewer than 3");
}

/// Reads the name of a solid, up to the end of its line, or up to `facet normal` where the file has
/// all on one line.
std::string read_name(Text_scanner& scan)
{
  std::string name;
  Text_scanner ahead = scan;
  for (std::string_view word = ahead.word(); !word.empty(); word = ahead.word()) {
    if (is_word(word, "facet") && is_word(Text_scanner(ahead).word(), "normal"))
      break;
    name += (name.empty() ? "" : " ") + std::string(word);
    scan = ahead;
  }
  return name;
}

/// Names of solids may hold any word, and solids may be several.
Input_mesh read_text(const std::string& file, std::string_view bytes)
{
  Text_scanner scan(file, bytes, Text_scanner::no_comments);
  std::vector<Point> points;
  Face_set_builder solids;
  bool is_in_solid = false;
  for (std::string_view word = scan.word_of_any_line(); !word.empty();
       word = scan.word_of_any_line()) {
    const bool is_end = is_word(word.substr(0, 8), "endsolid") || // a name may follow at once
                        (is_word(word, "end") && is_word(scan.word_of_any_line(), "solid"));
    if (is_word(word, "solid") && !is_in_solid) {
      is_in_solid = true;
      if (const std::string name = read_name(scan); name.empty())
        solids.start_new(name, points.size() / 3);
      else
        solids.start(name, points.size() / 3);
    } else if (is_end && is_in_solid) {
      read_name(scan);
      is_in_solid = scan.has_word(); // the start of the next solid was taken for this name
    } else if (is_word(word, "facet") && is_in_solid) {
      read_facet(scan, points);
    } else if (is_word(word, "color") && is_in_solid) {
      for (int i = 0; i < 3; ++i)
        scan.word();
    } else
      scan.fail(in_quotes(word) +
                (is_in_solid ? " where 'facet' or 'endsolid' is due" : " where 'solid' is due"));
  }
  if (is_in_solid)
    scan.fail("the file ends before 'endsolid'");
  Input_mesh input;
  input.soup = triangles_on(std::move(points));
  input.properties.of(Set_kind::SOLIDS) = solids.build(input.soup.polygons.size());
  return input;
}

} // namespace

Input_mesh read_stl(const std::string& file, std::string_view bytes)
{
  return is_text(bytes) ? read_text(file, bytes) : read_binary(file, bytes);
}

} // namespace segment_mesh
