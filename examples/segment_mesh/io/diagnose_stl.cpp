// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Text_scanner.h"
#include "io/diagnose_input.h"
#include "io/errors.h"
#include "io/little_endian.h"

#include <algorithm>
#include <cmath>

namespace segment_mesh {

namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t data_offset = header_size + 4;
constexpr std::size_t triangle_size = 50; // a normal and 3 points as floats, 2 bytes of attributes

std::size_t promised_triangles(const std::string& bytes)
{
  return bytes.size() < data_offset ? 0 : read_little_endian<std::uint32_t>(&bytes[header_size]);
}

/// Binary files whose header starts with "solid" do exist.
bool is_text(const std::string& bytes)
{
  const bool has_size_of_binary =
    bytes.size() >= data_offset &&
    bytes.size() == data_offset + triangle_size * promised_triangles(bytes);
  const std::size_t start = (std::min)(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  return !has_size_of_binary && bytes.compare(start, 5, "solid") == 0 &&
         bytes.find('\0') == std::string::npos;
}

void check_binary(const std::string& file, const std::string& bytes)
{
  if (bytes.size() < data_offset)
    throw Input_error(file,
                      "neither a text that starts with 'solid' nor long enough for a binary STL");
  const std::size_t promised = promised_triangles(bytes);
  const std::size_t available = (bytes.size() - data_offset) / triangle_size;
  if (promised > available)
    throw Input_error(file, "the header promises " + counted(promised, "triangle") +
                              ", the file ends after " + std::to_string(available));
  if (promised == 0)
    throw Input_error(file, "no faces");
  for (std::size_t i = 0; i < promised; ++i)
    for (std::size_t j = 3; j < 12; ++j) // the points; CGAL skips the normal
      if (!std::isfinite(
            read_little_endian<float>(&bytes[data_offset + triangle_size * i + 4 * j])))
        throw Input_error(file, "triangle " + std::to_string(i) +
                                  ", from 0, has a coordinate that is not a finite number");
}

/// The rest of a facet, after its first word.
void check_facet(Text_scanner& scan, std::string& output)
{
  output += "facet\n";
  int size = 0;
  for (std::string_view word = scan.word_of_any_line(); word != "endfacet";
       word = scan.word_of_any_line()) {
    if (word.empty())
      scan.fail("the file ends within a facet");
    if (word != "vertex")
      continue;
    if (++size > 3)
      scan.fail("a facet with more than 3 vertices");
    output += "vertex";
    for (int i = 0; i < 3; ++i) {
      const std::string_view coordinate = scan.word_of_any_line();
      if (coordinate.empty())
        scan.fail("the file ends within a facet");
      scan.finite_number(coordinate);
      (output += ' ') += coordinate;
    }
    output += '\n';
  }
  if (size < 3)
    scan.fail("a face with " + counted(std::size_t(size), "vertex") + ", fewer than 3");
  output += "endfacet\n";
}

/// Names of solids may hold any word, and solids may be several: CGAL is given one without a name.
std::string check_text(const std::string& file, const std::string& bytes)
{
  Text_scanner scan(file, bytes, Text_scanner::no_comments);
  std::string output = "solid\n";
  bool is_in_solid = false, has_faces = false;
  while (scan.next_line()) {
    const std::string_view word = scan.word();
    if (word == "solid" && !is_in_solid) {
      is_in_solid = true;
    } else if (word == "endsolid" && is_in_solid) {
      is_in_solid = false;
    } else if (word == "facet" && is_in_solid) {
      check_facet(scan, output);
      has_faces = true;
    } else {
      scan.fail(in_quotes(word) +
                (is_in_solid ? " where 'facet' or 'endsolid' is due" : " where 'solid' is due"));
    }
  }
  if (is_in_solid)
    scan.fail("the file ends before 'endsolid'");
  if (!has_faces)
    throw Input_error(file, "no faces");
  return output += "endsolid\n";
}

} // namespace

std::string diagnose_stl(const std::string& file, std::string bytes)
{
  if (is_text(bytes))
    return check_text(file, bytes);
  check_binary(file, bytes);
  // No header that CGAL could take for that of a text, or for a blank to skip.
  std::fill_n(bytes.begin(), header_size, 'b');
  return bytes;
}

} // namespace segment_mesh
