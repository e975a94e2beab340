// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEXT_BUFFER_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEXT_BUFFER_H

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace segment_mesh {

/// Text on its way to a stream. Numbers have the fewest digits from which they are read back to the
/// bit, whatever the locale.
class Text_buffer
{
public:
  explicit Text_buffer(std::ostream& out)
    : m_out(out)
  {}
  Text_buffer(const Text_buffer&) = delete;
  Text_buffer& operator=(const Text_buffer&) = delete;
  ~Text_buffer() { flush(); }

  Text_buffer& operator<<(std::string_view text)
  {
    m_text += text;
    if (m_text.size() > 60000)
      flush();
    return *this;
  }

  template <typename Number, typename = std::enable_if_t<std::is_arithmetic<Number>::value>>
  Text_buffer& operator<<(Number number)
  {
    char digits[32];
    return *this << std::string_view(digits, std::size_t(end_of(number, digits) - digits));
  }

private:
  /// Writes the digits, and gives the end of them.
  template <typename Number>
  static char* end_of(Number number, char (&digits)[32])
  {
#ifndef __cpp_lib_to_chars // for numbers with a fraction not in every library of C++
    if constexpr (std::is_floating_point<Number>::value) {
      int size = 0, precision = std::numeric_limits<Number>::digits10;
      do
        size = std::snprintf(digits, sizeof digits, "%.*g", precision, double(number));
      while (Number(std::strtod(digits, nullptr)) != number &&
             precision++ < std::numeric_limits<Number>::max_digits10);
      return digits + size;
    } else
#endif
      return std::to_chars(digits, digits + sizeof digits, number).ptr;
  }

  void flush()
  {
    m_out.write(m_text.data(), std::streamsize(m_text.size()));
    m_text.clear();
  }

  std::ostream& m_out;
  std::string m_text;
};

/// With a blank between two; `start` before the first one.
template <typename Numbers>
void write_numbers(Text_buffer& text, const char* start, const Numbers& numbers)
{
  const char* separator = start;
  for (const auto number : numbers) {
    text << separator << number;
    separator = " ";
  }
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEXT_BUFFER_H
