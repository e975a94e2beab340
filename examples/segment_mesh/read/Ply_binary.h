// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLY_BINARY_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLY_BINARY_H

#include "read/Ply_header.h"
#include "read/errors.h"
#include "read/little_endian.h"

#include <cmath>
#include <string>
#include <string_view>

namespace segment_mesh {

/// The values of a binary PLY file.
class Ply_binary
{
public:
  /// `data` is what follows the header.
  Ply_binary(const std::string& file, std::string_view data, Ply_format format)
    : m_file(file)
    , m_data(data)
    , m_is_little_endian(format == Ply_format::BINARY_LITTLE_ENDIAN)
  {}

  static std::size_t least_size_of(Ply_type type) { return size_of(type); }
  std::size_t available() const { return m_data.size(); }

  /// The values that follow are of this item.
  void start(const Ply_element& element, std::uint64_t item)
  {
    m_element = &element;
    m_item = item;
  }

  /// \pre the type is an integer
  std::int64_t integer(Ply_type type) { return take<std::int64_t>(type); }

  double coordinate(const Ply_property& property)
  {
    const double value = take<double>(property.type);
    if (!std::isfinite(value))
      fail(property.name + " is not a finite number");
    return value;
  }

  void skip(Ply_type type, std::uint64_t number)
  {
    if (m_data.size() / size_of(type) < number)
      throw Input_error(m_file, cut_off(*m_element, m_item));
    m_data.remove_prefix(std::size_t(number) * size_of(type));
  }

  /// What is not read; empty at the end of the file.
  std::string rest() const
  {
    return m_data.empty() ? std::string() : bytes_not_read(m_file, m_data.size()) + " at the end";
  }

  [[noreturn]] void fail(const std::string& cause) const
  {
    throw Input_error(m_file,
                      m_element->name + " " + std::to_string(m_item) + ", from 0: " + cause);
  }

private:
  template <typename Result>
  Result take(Ply_type type)
  {
    return with_type(type, [this](auto zero) {
      using Value = decltype(zero);
      if (m_data.size() < sizeof(Value))
        throw Input_error(m_file, cut_off(*m_element, m_item));
      const Value value = read_bytes<Value>(m_data.data(), m_is_little_endian);
      m_data.remove_prefix(sizeof(Value));
      return Result(value);
    });
  }

  std::string m_file;
  std::string_view m_data;
  bool m_is_little_endian;
  const Ply_element* m_element = nullptr;
  std::uint64_t m_item = 0;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLY_BINARY_H
