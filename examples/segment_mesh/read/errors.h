// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ERRORS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ERRORS_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace segment_mesh {

/// What the user should know, a line each.
using Remarks = std::vector<std::string>;

/// A message that stays on its line of a terminal or a log: a `?` in place of each control
/// character of ASCII, and of U+0080 to U+009F.
inline std::string one_line(std::string text)
{
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = [&](std::size_t at) {
      return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
    };
    if (byte(i) < 0x20 || byte(i) == 0x7f)
      text[i] = '?';
    else if (byte(i) == 0xc2 && byte(i + 1) >= 0x80 && byte(i + 1) < 0xa0)
      text.replace(i, 2, "?");
  }
  return text;
}

/// An input that cannot be read or is not usable. The message is one line: `file: cause`, or
/// `file:line: cause`.
class Input_error : public std::runtime_error
{
public:
  Input_error(const std::string& file, const std::string& cause)
    : std::runtime_error(one_line(file + ": " + cause))
  {}

  Input_error(const std::string& file, std::size_t line, const std::string& cause)
    : std::runtime_error(one_line(file + ":" + std::to_string(line) + ": " + cause))
  {}
};

/// What is wrong with a value; who knows its place makes an `Input_error` of it.
class Value_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// An output that could not be written. The message is one line: `file: cause`.
class Output_error : public std::runtime_error
{
public:
  Output_error(const std::string& file, const std::string& cause)
    : std::runtime_error(one_line(file + ": " + cause))
  {}
};

/// A command line that makes no sense.
class Usage_error : public std::runtime_error
{
public:
  explicit Usage_error(const std::string& cause)
    : std::runtime_error(one_line(cause))
  {}
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ERRORS_H
