// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ERRORS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ERRORS_H

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace segment_mesh {

/// A message that stays on its line of a terminal or a log, whatever bytes it quotes.
inline std::string one_line(std::string text)
{
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  std::replace_if(text.begin(), text.end(), is_control, '?');
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
