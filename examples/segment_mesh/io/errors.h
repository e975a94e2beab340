// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ERRORS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ERRORS_H

#include <cstddef>
#include <stdexcept>
#include <string>

namespace segment_mesh {

/// A message that stays on its line of a terminal or a log, whatever bytes it quotes: a `?` in place of each control character of
/// ASCII, and of U+0080 to U+009F, as UTF-8 or as single bytes.
inline std::string one_line(std::string text)
{
  const auto byte = [&text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0; };
  const auto is_continuation = [&byte](std::size_t i) { return (byte(i) & 0xc0) == 0x80; };
  for (std::size_t i = 0; i < text.size(); ++i) {
    // The bytes of a character of UTF-8 that follow its first one.
    const std::size_t expected = byte(i) >= 0xf0 ? 3 : byte(i) >= 0xe0 ? 2 : byte(i) >= 0xc2 ? 1 : 0;
    std::size_t found = 0;
    while (found < expected && is_continuation(i + found + 1))
      ++found;
    if (found > 0 && found == expected && !(byte(i) == 0xc2 && byte(i + 1) < 0xa0))
      i += found;
    else if (byte(i) < 0x20 || (byte(i) >= 0x7f && byte(i) < 0xa0))
      text[i] = '?';
    else if (found > 0 && found == expected)
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
  {
  }

  Input_error(const std::string& file, std::size_t line, const std::string& cause)
      : std::runtime_error(one_line(file + ":" + std::to_string(line) + ": " + cause))
  {
  }
};

/// An output that could not be written. The message is one line: `file: cause`.
class Output_error : public std::runtime_error
{
public:
  Output_error(const std::string& file, const std::string& cause)
      : std::runtime_error(one_line(file + ": " + cause))
  {
  }
};

/// A command line that makes no sense.
class Usage_error : public std::runtime_error
{
public:
  explicit Usage_error(const std::string& cause) : std::runtime_error(one_line(cause)) {}
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ERRORS_H
