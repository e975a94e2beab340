// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/copy_ply.h"

#include "io/Ply_header.h"
#include "io/errors.h"
#include "io/little_endian.h"
#include "view/segment_colors.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>

namespace segment_mesh {

namespace {

constexpr const char* added_properties =
  "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int segment\n";

bool is_replaced(const Ply_element& element, const Ply_property& property)
{
  return element.is_face() && (property.name == "red" || property.name == "green" || property.name == "blue" ||
                               property.name == "segment");
}

/// The lines of a header, without the properties that are replaced, and with those that are added after the others of a
/// face.
std::string copy_header(std::string_view bytes, const Ply_header& header)
{
  std::string copy;
  Text_scanner scan("", bytes, Text_scanner::no_comments);
  auto next_element = header.elements.begin();
  std::size_t property = 0; // the next one of the element before `next_element`
  for (bool is_inside = true; is_inside;) {
    const std::size_t start = scan.offset_of_next_line();
    scan.next_line();
    const std::string_view line = bytes.substr(start, scan.offset_of_next_line() - start), keyword = scan.word();
    is_inside = keyword != "end_header";
    const bool ends_element = !is_inside || keyword == "element";
    if (ends_element && next_element != header.elements.begin() && std::prev(next_element)->is_face())
      copy += added_properties;
    if (keyword == "element") {
      ++next_element;
      property = 0;
    }
    if (keyword != "property" || !is_replaced(*std::prev(next_element), std::prev(next_element)->properties[property++]))
      copy += line;
  }
  return copy;
}

/// The values of a text, each after a blank but the first of a line.
class Ply_words
{
public:
  explicit Ply_words(Text_scanner scan) : m_scan(std::move(scan)) {}

  std::string take(const Ply_property& property)
  {
    std::string words = word();
    if (!property.is_list)
      return words;
    const std::int64_t size = m_scan.integer(words, "a number of values");
    for (std::int64_t i = 0; i < size; ++i)
      words += " " + word();
    return words;
  }

  static void append(std::string& copy, const std::string& words)
  {
    if (copy.back() != '\n')
      copy += ' ';
    copy += words;
  }

  static void append_segment(std::string& copy, std::size_t segment)
  {
    for (std::uint8_t channel : segment_color(segment))
      append(copy, std::to_string(channel));
    append(copy, std::to_string(segment));
  }

  static void end_item(std::string& copy) { copy += '\n'; }

private:
  std::string word()
  {
    const std::string_view result = m_scan.word_of_any_line();
    if (result.empty())
      m_scan.fail("the file is cut off");
    return std::string(result);
  }

  Text_scanner m_scan;
};

/// The values of a binary file, in its order of bytes.
class Ply_bytes
{
public:
  Ply_bytes(std::string_view data, Ply_format format)
      : m_data(data), m_is_little_endian(format == Ply_format::BINARY_LITTLE_ENDIAN)
  {
  }

  std::string_view take(const Ply_property& property)
  {
    std::uint64_t size = size_of(property.type);
    if (property.is_list) {
      check(size_of(property.size_type));
      const std::int64_t number = with_type(property.size_type, [this](auto zero) {
        return std::int64_t(read_bytes<decltype(zero)>(m_data.data(), m_is_little_endian));
      });
      check(std::uint64_t((std::max)(number, std::int64_t(0)))); // each value takes a byte or more
      size = size_of(property.size_type) + std::uint64_t((std::max)(number, std::int64_t(0))) * size;
    }
    check(size);
    const std::string_view bytes = m_data.substr(0, std::size_t(size));
    m_data.remove_prefix(bytes.size());
    return bytes;
  }

  static void append(std::string& copy, std::string_view bytes) { copy += bytes; }

  void append_segment(std::string& copy, std::size_t segment) const
  {
    for (std::uint8_t channel : segment_color(segment))
      copy += char(channel);
    append_little_endian(copy, std::int32_t(segment));
    if (!m_is_little_endian)
      std::reverse(copy.end() - sizeof(std::int32_t), copy.end());
  }

  static void end_item(std::string&) {}

private:
  void check(std::uint64_t size) const
  {
    if (m_data.size() < size)
      throw Input_error("", "the file is cut off");
  }

  std::string_view m_data;
  bool m_is_little_endian;
};

template <typename Values>
void copy_items(std::string& copy, const Ply_header& header, Values values, const std::vector<std::size_t>& segment_of_face)
{
  auto segment = segment_of_face.begin();
  for (const Ply_element& element : header.elements)
    for (std::uint64_t item = 0; item < element.count; ++item) {
      for (const Ply_property& property : element.properties) {
        const auto value = values.take(property);
        if (!is_replaced(element, property))
          values.append(copy, value);
      }
      if (element.is_face())
        values.append_segment(copy, *segment++);
      values.end_item(copy);
    }
}

std::string make_copy(std::string_view bytes, const std::vector<std::size_t>& segment_of_face)
{
  Text_scanner scan("", bytes, Text_scanner::no_comments);
  const Ply_header header = read_ply_header("", scan);
  std::uint64_t number_of_faces = 0;
  for (const Ply_element& element : header.elements)
    number_of_faces += element.is_face() ? element.count : 0;
  if (number_of_faces != segment_of_face.size())
    throw Input_error("", "not the faces that were segmented");
  const std::string_view data = bytes.substr(scan.offset_of_next_line());
  std::string copy = copy_header(bytes, header);
  if (header.format == Ply_format::ASCII)
    copy_items(copy, header, Ply_words(std::move(scan)), segment_of_face);
  else
    copy_items(copy, header, Ply_bytes(data, header.format), segment_of_face);
  return copy;
}

} // namespace

std::optional<std::string> copy_ply(const std::string& bytes, const std::vector<std::size_t>& segment_of_face)
{
  try {
    return make_copy(bytes, segment_of_face);
  } catch (const Input_error&) {
    return std::nullopt;
  }
}

} // namespace segment_mesh
