// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLY_TEXT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLY_TEXT_H

#include "read/Ply_header.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace segment_mesh {

/// The values of a PLY file that is a text, where an item may span lines.
class Ply_text
{
public:
  /// `scan` is at the last line of the header.
  explicit Ply_text(Text_scanner scan)
    : m_scan(std::move(scan))
  {}

  /// A digit and a blank.
  static std::size_t least_size_of(Ply_type) { return 2; }
  std::size_t available() const { return m_scan.available(); }

  /// The values that follow are of this item.
  void start(const Ply_element& element, std::uint64_t item)
  {
    m_element = &element;
    m_item = item;
  }

  /// \pre the type is an integer
  std::int64_t integer(Ply_type type)
  {
    const std::int64_t value = m_scan.integer(word(), "an integer");
    const bool is_in_range = with_type(type, [value](auto zero) {
      using Limits = std::numeric_limits<decltype(zero)>;
      return value >= std::int64_t((Limits::min)()) && value <= std::int64_t((Limits::max)());
    });
    if (!is_in_range)
      fail(std::to_string(value) + " is too large for its type");
    return value;
  }

  double coordinate(const Ply_property& property)
  {
    if (!is_floating_point(property.type))
      return double(integer(property.type));
    const std::string_view value = word();
    const double number = m_scan.finite_number(value);
    if (property.type == Ply_type::FLOAT64)
      return number;
    if (!std::isfinite(float(number)))
      fail(in_quotes(value) + " is not a finite number as a float");
    return float(number);
  }

  void skip(Ply_type, std::uint64_t number)
  {
    for (std::uint64_t i = 0; i < number; ++i)
      word();
  }

  /// What is not read; empty at the end of the file.
  std::string rest()
  {
    return m_scan.has_word() || m_scan.next_line() ? m_scan.not_read() : std::string();
  }

  [[noreturn]] void fail(const std::string& cause) const { m_scan.fail(cause); }

private:
  std::string_view word()
  {
    const std::string_view result = m_scan.word_of_any_line();
    if (result.empty())
      fail(cut_off(*m_element, m_item));
    return result;
  }

  Text_scanner m_scan;
  const Ply_element* m_element = nullptr;
  std::uint64_t m_item = 0;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLY_TEXT_H
