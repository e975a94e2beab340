// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Ply_header.h"
#include "io/Text_scanner.h"
#include "io/diagnose_input.h"
#include "io/errors.h"
#include "io/little_endian.h"

#include <cmath>

namespace segment_mesh {

namespace {

std::string index_out_of_range(std::int64_t index, const Ply_header& header)
{
  return "index " + std::to_string(index) + " is out of range: there are " +
         counted(std::size_t(header.number_of_vertices), "vertex") + ", from 0";
}

bool is_out_of_range(std::int64_t index, const Ply_header& header)
{
  return index < 0 || std::uint64_t(index) >= header.number_of_vertices;
}

std::string cut_off(const Ply_element& element, std::uint64_t item)
{
  return "the header promises " + std::to_string(element.count) + " items of element " +
         in_quotes(element.name) + ", the file ends after " + std::to_string(item);
}

std::string list_of_negative_size(std::int64_t size)
{
  return "a list of " + std::to_string(size) + " values";
}

/// The data of a text file, where an item may span lines.
class Ply_text
{
public:
  Ply_text(const std::string& file, const std::string& bytes, const Ply_header& header)
      : m_header(header), m_scan(file, std::string_view(bytes).substr(header.data_offset),
                                 Text_scanner::no_comments, header.number_of_lines + 1)
  {
  }

  void check()
  {
    for (const Ply_element& element : m_header.elements)
      for (std::uint64_t i = 0; i < element.count; ++i)
        for (const Ply_property& property : element.properties)
          check_property(element, i, property);
  }

private:
  std::string_view word(const Ply_element& element, std::uint64_t item)
  {
    const std::string_view result = m_scan.word_of_any_line();
    if (result.empty())
      m_scan.fail(cut_off(element, item));
    return result;
  }

  std::int64_t integer(std::string_view word, Ply_type type) const
  {
    const std::int64_t value = m_scan.integer(word, "an integer");
    if (value < least(type) || value > greatest(type))
      m_scan.fail(std::to_string(value) + " is too large for its type");
    return value;
  }

  void check_property(const Ply_element& element, std::uint64_t item, const Ply_property& property)
  {
    std::int64_t size = 1;
    if (property.is_list)
      size = integer(word(element, item), property.size_type);
    if (property.is_face && size < 3)
      m_scan.fail("a face with " + std::to_string(size) + " vertices, fewer than 3");
    if (size < 0)
      m_scan.fail(list_of_negative_size(size));
    for (std::int64_t i = 0; i < size; ++i) {
      const std::string_view value = word(element, item);
      if (is_floating_point(property.type)) {
        const double number = m_scan.finite_number(value);
        if (property.type == Ply_type::FLOAT32 && !std::isfinite(float(number)))
          m_scan.fail(in_quotes(value) + " is not a finite number as a float");
        continue;
      }
      const std::int64_t number = integer(value, property.type);
      if (property.is_face && is_out_of_range(number, m_header))
        m_scan.fail(index_out_of_range(number, m_header));
    }
  }

  const Ply_header& m_header;
  Text_scanner m_scan;
};

/// The data of a binary file.
class Ply_binary
{
public:
  Ply_binary(const std::string& file, const std::string& bytes, const Ply_header& header)
      : m_file(file), m_header(header), m_at(bytes.data() + header.data_offset),
        m_end(bytes.data() + bytes.size()),
        m_is_little_endian(header.format == "binary_little_endian")
  {
  }

  void check()
  {
    for (const Ply_element& element : m_header.elements) {
      // Without properties there are no items either, see read_ply_header().
      if (element.properties.empty())
        continue;
      if (!element.has_lists() && element.count > available() / element.size_of_item())
        throw Input_error(m_file, cut_off(element, available() / element.size_of_item()));
      for (std::uint64_t i = 0; i < element.count; ++i)
        for (const Ply_property& property : element.properties)
          check_property(element, i, property);
    }
  }

private:
  std::size_t available() const { return std::size_t(m_end - m_at); }

  [[noreturn]] void fail(const Ply_element& element, std::uint64_t item,
                         const std::string& cause) const
  {
    throw Input_error(m_file, element.name + " " + std::to_string(item) + ", from 0: " + cause);
  }

  template <typename T>
  T take()
  {
    const T value = read_bytes<T>(m_at, m_is_little_endian);
    m_at += sizeof(T);
    return value;
  }

  std::int64_t take_integer(Ply_type type)
  {
    switch (type) {
    case Ply_type::INT8:
      return take<std::int8_t>();
    case Ply_type::UINT8:
      return take<std::uint8_t>();
    case Ply_type::INT16:
      return take<std::int16_t>();
    case Ply_type::UINT16:
      return take<std::uint16_t>();
    case Ply_type::INT32:
      return take<std::int32_t>();
    default:
      return take<std::uint32_t>();
    }
  }

  void check_property(const Ply_element& element, std::uint64_t item, const Ply_property& property)
  {
    std::int64_t size = 1;
    if (property.is_list) {
      if (available() < size_of(property.size_type))
        throw Input_error(m_file, cut_off(element, item));
      size = take_integer(property.size_type);
      if (size < 0)
        fail(element, item, list_of_negative_size(size));
    }
    if (available() / size_of(property.type) < std::uint64_t(size))
      throw Input_error(m_file, cut_off(element, item));
    if (property.is_face)
      check_face(element, item, property, size);
    else if (property.is_coordinate)
      check_coordinate(element, item, property);
    else
      m_at += std::size_t(size) * size_of(property.type);
  }

  void check_face(const Ply_element& element, std::uint64_t item, const Ply_property& property,
                  std::int64_t size)
  {
    if (size < 3)
      fail(element, item, "a face with " + std::to_string(size) + " vertices, fewer than 3");
    for (std::int64_t i = 0; i < size; ++i) {
      const std::int64_t index = take_integer(property.type);
      if (is_out_of_range(index, m_header))
        fail(element, item, index_out_of_range(index, m_header));
    }
  }

  void check_coordinate(const Ply_element& element, std::uint64_t item,
                        const Ply_property& property)
  {
    const double value = property.type == Ply_type::FLOAT32 ? take<float>() : take<double>();
    if (!std::isfinite(value))
      fail(element, item, property.name + " is not a finite number");
  }

  std::string m_file;
  const Ply_header& m_header;
  const char *m_at, *m_end;
  bool m_is_little_endian;
};

} // namespace

std::string diagnose_ply(const std::string& file, const std::string& bytes)
{
  const Ply_header header = read_ply_header(file, bytes);
  if (header.format == "ascii")
    Ply_text(file, bytes, header).check();
  else
    Ply_binary(file, bytes, header).check();
  return header.text().append(bytes, header.data_offset, std::string::npos);
}

} // namespace segment_mesh
