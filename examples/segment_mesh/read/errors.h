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

/// Of the character of UTF-8 that begins at `at`: 1 if none does.
inline std::size_t size_of_character(const std::string& text, std::size_t at)
{
  const auto byte = [&text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  const std::size_t expected = byte(at) >= 0xf0   ? 4
                               : byte(at) >= 0xe0 ? 3
                               : byte(at) >= 0xc2 ? 2
                                                  : 1;
  std::size_t size = 1;
  while (size < expected && (byte(at + size) & 0xc0) == 0x80)
    ++size;
  return size == expected ? size : 1;
}

/// A message that stays on its line of a terminal or a log, whatever bytes it quotes: a `?` in
/// place of each control character of ASCII, and of U+0080 to U+009F, as UTF-8 or as single bytes.
inline std::string one_line(std::string text)
{
  for (std::size_t at = 0, size = 1; at < text.size(); at += size) {
    size = size_of_character(text, at);
    // The control characters from U+0080 to U+009F have their own value as second byte.
    const auto value = static_cast<unsigned char>(
      text[size == 2 && text[at] == '\xc2' ? at + 1 : at]);
    const bool is_control = size <= 2 && (value < 0x20 || (value >= 0x7f && value < 0xa0));
    if (is_control) {
      text.replace(at, size, "?");
      size = 1;
    }
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
