// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Text_scanner.h"
#include "io/diagnose_input.h"

#include <algorithm>

namespace segment_mesh {

namespace {

struct Off_header
{
  std::size_t keyword_offset, keyword_size;
  bool is_homogeneous;
  std::int64_t number_of_vertices, number_of_faces;
};

std::int64_t read_count(Text_scanner& scan, const char* what)
{
  const std::string_view word = scan.word_of_any_line();
  if (word.empty())
    scan.fail(std::string("the file ends where the header has ") + what);
  const std::int64_t count = scan.integer(word, what);
  if (count < 0)
    scan.fail(std::to_string(count) + " is not " + what);
  return count;
}

/// `[ST][C][N][4]OFF`, and the numbers of vertices, faces and edges.
Off_header read_header(Text_scanner& scan, const std::string& bytes)
{
  const std::string_view keyword = scan.word_of_any_line();
  std::string_view rest = keyword;
  const auto skip = [&rest](std::string_view prefix) {
    const bool is_there = rest.substr(0, prefix.size()) == prefix;
    rest.remove_prefix(is_there ? prefix.size() : 0);
    return is_there;
  };
  skip("ST");
  skip("C");
  skip("N");
  Off_header header{};
  header.is_homogeneous = skip("4");
  if (rest != "OFF")
    scan.fail("no OFF header, but " + in_quotes(keyword));
  header.keyword_offset = std::size_t(keyword.data() - bytes.data());
  header.keyword_size = keyword.size();

  Text_scanner ahead = scan;
  if (ahead.word_of_any_line() == "BINARY")
    scan.fail("binary OFF is not supported");
  header.number_of_vertices = read_count(scan, "a number of vertices");
  header.number_of_faces = read_count(scan, "a number of faces");
  read_count(scan, "a number of edges");
  if (header.number_of_faces == 0)
    scan.fail("no faces");
  return header;
}

[[noreturn]] void fail_at_end(const Text_scanner& scan, std::int64_t item, std::int64_t promised,
                              const std::string& what)
{
  scan.fail("the header promises " + counted(std::size_t(promised), what) +
            ", the file ends after " + std::to_string(item));
}

void check_vertices(Text_scanner& scan, const Off_header& header)
{
  const int size = header.is_homogeneous ? 4 : 3;
  for (std::int64_t i = 0; i < header.number_of_vertices; ++i) {
    // What is left of the header's line is the first vertex.
    if (!(i == 0 && scan.has_word()) && !scan.next_line())
      fail_at_end(scan, i, header.number_of_vertices, "vertex");
    double value = 0;
    for (int j = 0; j < size; ++j) {
      const std::string_view word = scan.word();
      if (word.empty())
        scan.fail("a vertex with " + std::to_string(j) + " of " + std::to_string(size) +
                  " coordinates");
      value = scan.finite_number(word);
    }
    if (header.is_homogeneous && value == 0)
      scan.fail("a vertex at infinity: its fourth coordinate is 0");
  }
}

void check_faces(Text_scanner& scan, const Off_header& header)
{
  for (std::int64_t i = 0; i < header.number_of_faces; ++i) {
    if (!scan.next_line())
      fail_at_end(scan, i, header.number_of_faces, "face");
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
    }
  }
}

} // namespace

std::string diagnose_off(const std::string& file, std::string bytes)
{
  Text_scanner scan(file, bytes, '#');
  const Off_header header = read_header(scan, bytes);
  check_vertices(scan, header);
  check_faces(scan, header);

  // Normals, colors and textures follow the coordinates, so a reader that is not told of them skips
  // them. CGAL's indexes past the line where they are missing.
  std::string keyword = header.is_homogeneous ? "4OFF" : "OFF";
  keyword.resize(header.keyword_size, ' ');
  std::copy(keyword.begin(), keyword.end(), bytes.begin() + std::ptrdiff_t(header.keyword_offset));
  return bytes;
}

} // namespace segment_mesh
