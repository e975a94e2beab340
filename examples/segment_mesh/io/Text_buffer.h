// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEXT_BUFFER_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEXT_BUFFER_H

#include <charconv>
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
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    return *this << std::string_view(digits, std::size_t(end - digits));
  }

private:
  void flush()
  {
    m_out.write(m_text.data(), std::streamsize(m_text.size()));
    m_text.clear();
  }

  std::ostream& m_out;
  std::string m_text;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEXT_BUFFER_H
