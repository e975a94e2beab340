// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/Text_scanner.h"
#include "read/errors.h"
#include "read/read_soup.h"
#include "soup/vector_algebra.h"

#include <algorithm>

namespace segment_mesh {

namespace {

/// Bytes of the shortest line of a vertex, and of a face.
constexpr std::size_t least_vertex_size = 6, least_face_size = 8;

struct Off_header
{
  bool is_homogeneous;
  std::int64_t number_of_vertices, number_of_faces;
};

std::int64_t read_count(Text_scanner& scan, std::string_view word, const char* what)
{
  if (word.empty())
    scan.fail(std::string("the file ends where the header has ") + what);
  const std::int64_t count = scan.integer(word, what);
  if (count < 0)
    scan.fail(std::to_string(count) + " is not " + what);
  return count;
}

bool skip(std::string_view prefix, std::string_view& text)
{
  const bool is_there = text.substr(0, prefix.size()) == prefix;
  text.remove_prefix(is_there ? prefix.size() : 0);
  return is_there;
}

/// `[ST][C][N][4]OFF`, and the numbers of vertices, faces and edges, the first of which may follow
/// without a blank.
Off_header read_header(Text_scanner& scan)
{
  const std::string_view keyword = scan.word_of_any_line();
  std::string_view rest = keyword;
  skip("ST", rest);
  skip("C", rest);
  skip("N", rest);
  Off_header header{};
  header.is_homogeneous = skip("4", rest);
  if (!skip("OFF", rest) || rest.find_first_not_of("0123456789") != std::string_view::npos)
    scan.fail("no OFF header, but " + in_quotes(keyword));
  const std::string_view first = rest.empty() ? scan.word_of_any_line() : rest;
  if (first == "BINARY")
    scan.fail("binary OFF is not supported");
  header.number_of_vertices = read_count(scan, first, "a number of vertices");
  header.number_of_faces = read_count(scan, scan.word_of_any_line(), "a number of faces");
  read_count(scan, scan.word_of_any_line(), "a number of edges");
  if (header.number_of_faces == 0)
    scan.fail("no faces");
  return header;
}

/// Goes to the line of the item that is due.
/// \throws Input_error if there is none
void next_item(Text_scanner& scan, std::size_t item, std::size_t promised, const std::string& what)
{
  if (!scan.next_line())
    scan.fail("the header promises " + counted(promised, what) + ", the file ends after " +
              std::to_string(item) + " (each on a line of its own)");
}

Point read_point(Text_scanner& scan, const Off_header& header)
{
  const std::size_t size = header.is_homogeneous ? 4 : 3;
  double values[4];
  for (std::size_t j = 0; j < size; ++j) {
    const std::string_view word = scan.word();
    if (word.empty())
      scan.fail("a vertex with " + std::to_string(j) + " of " + std::to_string(size) +
                " coordinates");
    values[j] = scan.finite_number(word);
  }
  if (!header.is_homogeneous)
    return {values[0], values[1], values[2]};
  if (values[3] == 0)
    scan.fail("a vertex at infinity: its fourth coordinate is 0");
  const Point point = {values[0] / values[3], values[1] / values[3], values[2] / values[3]};
  if (!is_finite(point))
    scan.fail("a vertex whose coordinates, divided by the fourth, are not finite numbers");
  return point;
}

void read_face(Text_scanner& scan, const Off_header& header, Polygons& polygons)
{
  const std::int64_t size = scan.integer(scan.word(), "a number of vertices of a face");
  if (size < 3)
    scan.fail("a face with " + std::to_string(size) + " vertices, fewer than 3");
  for (std::int64_t j = 0; j < size; ++j) {
    const std::string_view word = scan.word();
    if (word.empty())
      scan.fail("a face with " + std::to_string(j) + " of " + std::to_string(size) + " indices");
    const std::int64_t index = scan.integer(word, "an index of a vertex");
    if (index < 0 || index >= header.number_of_vertices)
      scan.fail("index " + std::to_string(index) + " is out of range: there are " +
                counted(std::size_t(header.number_of_vertices), "vertex") + ", from 0");
    polygons.add_corner(std::size_t(index));
  }
  polygons.close_polygon();
}

} // namespace

Polygon_soup read_off(const std::string& file, std::string_view bytes, Remarks& remarks)
{
  if (bytes.find('\n') == std::string_view::npos && bytes.find('\r') != std::string_view::npos)
    throw Input_error(file, "its lines end with carriage returns alone, not with line feeds");
  Text_scanner scan(file, bytes, '#');
  const Off_header header = read_header(scan);
  const std::size_t number_of_vertices(header.number_of_vertices),
    number_of_faces(header.number_of_faces);
  Polygon_soup soup;
  soup.points.reserve((std::min)(number_of_vertices, bytes.size() / least_vertex_size));
  soup.polygons.reserve((std::min)(number_of_faces, bytes.size() / least_face_size));
  while (soup.points.size() < number_of_vertices) {
    // What is left of the header's line is the first vertex.
    if (!(soup.points.empty() && scan.has_word()))
      next_item(scan, soup.points.size(), number_of_vertices, "vertex");
    soup.points.push_back(read_point(scan, header));
  }
  while (soup.polygons.size() < number_of_faces) {
    next_item(scan, soup.polygons.size(), number_of_faces, "face");
    read_face(scan, header, soup.polygons);
  }
  if (scan.next_line())
    remarks.push_back(scan.not_read() + ": the header promises " +
                      counted(number_of_faces, "face"));
  return soup;
}

} // namespace segment_mesh
