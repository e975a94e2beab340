// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/Text_scanner.h"
#include "read/errors.h"
#include "read/read_mesh.h"

#include <algorithm>
#include <utility>

namespace segment_mesh {

namespace {

/// Bytes of the shortest line of a vertex, and of a face.
constexpr std::size_t least_vertex_size = 6, least_face_size = 8;

struct Off_header
{
  int number_of_values; // of a vertex: coordinates, and normal, color, texture, which are skipped
  std::int64_t number_of_vertices, number_of_faces;
};

/// How items lie in the text. Most programs write one on each line, perhaps with values that the
/// header does not name. The format has words that may be on any line.
enum class Off_layout { ITEMS_ON_LINES, WORDS };

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

/// `OFF` after `ST`, `C` and `N` for what vertices have, and the numbers of vertices, faces
/// and edges, the first of which may follow without a blank.
Off_header read_header(Text_scanner& scan)
{
  const std::string_view keyword = scan.word_of_any_line();
  std::string_view rest = keyword;
  Off_header header{};
  header.number_of_values = 3;
  const auto has = [&](const char* prefix, int number_of_values) {
    const bool is_there = skip(prefix, rest);
    header.number_of_values += is_there ? number_of_values : 0;
    return is_there;
  };
  while (has("C", 4) || has("N", 3) || has("ST", 2)) // in any order, as programs write them
    continue;
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

/// Reads the items that the header promises.
class Off_reader
{
public:
  Off_reader(Text_scanner scan, const Off_header& header, Off_layout layout)
    : m_scan(std::move(scan))
    , m_header(header)
    , m_layout(layout)
  {}

  Input_mesh read()
  {
    const std::size_t number_of_vertices(m_header.number_of_vertices),
      number_of_faces(m_header.number_of_faces);
    Input_mesh input;
    Polygon_soup& soup = input.soup;
    soup.points.reserve((std::min)(number_of_vertices, m_scan.available() / least_vertex_size + 1));
    soup.polygons.reserve((std::min)(number_of_faces, m_scan.available() / least_face_size + 1));
    while (soup.points.size() < number_of_vertices) {
      next_item(soup.points.size(), number_of_vertices, "vertex");
      soup.points.push_back(read_point());
      if (m_layout == Off_layout::ITEMS_ON_LINES)
        m_scan.skip_line();
    }
    while (soup.polygons.size() < number_of_faces) {
      next_item(soup.polygons.size(), number_of_faces, "face");
      read_face(soup.polygons);
      if (m_layout == Off_layout::ITEMS_ON_LINES)
        m_scan.skip_line();
    }
    if (go_to_word()) {
      if (m_layout != Off_layout::ITEMS_ON_LINES)
        m_scan.fail("more words than the header promises");
      input.remarks.push_back(m_scan.not_read() + ": the header promises " +
                              counted(number_of_faces, "face"));
    }
    return input;
  }

private:
  bool go_to_word() { return m_scan.has_word() || m_scan.next_line(); }

  void next_item(std::size_t item, std::size_t promised, const char* what)
  {
    if (!go_to_word())
      m_scan.fail("the header promises " + counted(promised, what) + ", the file ends after " +
                  std::to_string(item));
  }

  /// The next word of an item of which `size` words of a kind are due.
  std::string_view word(std::int64_t i, std::int64_t size, const char* item, const char* what)
  {
    const std::string_view word = m_layout == Off_layout::ITEMS_ON_LINES
                                    ? m_scan.word()
                                    : m_scan.word_of_any_line();
    if (word.empty())
      m_scan.fail(std::string(item) + " with " + std::to_string(i) + " of " + std::to_string(size) +
                  " " + what);
    return word;
  }

  Point read_point()
  {
    Point point;
    for (int j = 0; j < 3; ++j)
      point[std::size_t(j)] = m_scan.finite_number(word(j, 3, "a vertex", "coordinates"));
    for (int j = 3; m_layout == Off_layout::WORDS && j < m_header.number_of_values; ++j)
      word(j, m_header.number_of_values, "a vertex", "values");
    return point;
  }

  void read_face(Polygons& polygons)
  {
    const std::int64_t size = m_scan.integer(m_scan.word(), "a number of vertices of a face");
    if (size < 3)
      m_scan.fail("a face with " + std::to_string(size) + " vertices, fewer than 3");
    for (std::int64_t j = 0; j < size; ++j) {
      const std::int64_t index = m_scan.integer(word(j, size, "a face", "indices"),
                                                "an index of a vertex");
      if (index < 0 || index >= m_header.number_of_vertices)
        m_scan.fail(out_of_range(index, std::size_t(m_header.number_of_vertices), "vertex", 0));
      polygons.add_corner(std::size_t(index));
    }
    polygons.close_polygon();
  }

  Text_scanner m_scan;
  const Off_header m_header;
  const Off_layout m_layout;
};

} // namespace

Input_mesh read_off(const std::string& file, std::string_view bytes)
{
  Text_scanner scan(file, bytes, '#');
  const Off_header header = read_header(scan);
  try {
    return Off_reader(scan, header, Off_layout::ITEMS_ON_LINES).read();
  } catch (const Input_error& error) {
    try {
      return Off_reader(scan, header, Off_layout::WORDS).read();
    } catch (const Input_error&) {
      throw error; // the message on the usual layout is the clearest one
    }
  }
}

} // namespace segment_mesh
