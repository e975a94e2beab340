// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/copy_ply.h"

#include "io/little_endian.h"
#include "view/segment_colors.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <sstream>
#include <stdexcept>

namespace segment_mesh {

namespace {

/// The bytes are not what their header promises.
struct Not_as_expected : std::runtime_error
{
  Not_as_expected() : std::runtime_error("not a PLY file") {}
};

enum class Ply_format { ASCII, LITTLE_ENDIAN_BYTES, BIG_ENDIAN_BYTES };

struct Property
{
  std::string name, type;
  std::string count_type; ///< of a list

  bool is_list() const { return !count_type.empty(); }
  bool is_replaced() const { return name == "red" || name == "green" || name == "blue" || name == "segment"; }
};

struct Element
{
  std::string name;
  std::size_t number = 0;
  std::vector<Property> properties;
};

std::size_t size_of(const std::string& type)
{
  static const std::map<std::string, std::size_t> sizes = {
    {"char", 1}, {"int8", 1},  {"uchar", 1}, {"uint8", 1},  {"short", 2}, {"int16", 2},   {"ushort", 2}, {"uint16", 2},
    {"int", 4},  {"int32", 4}, {"uint", 4},  {"uint32", 4}, {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = sizes.find(type);
  if (found == sizes.end())
    throw Not_as_expected();
  return found->second;
}

class Ply_copy
{
public:
  Ply_copy(const std::string& bytes, const std::vector<std::size_t>& segment_of_face)
      : m_bytes(bytes), m_segment_of_face(segment_of_face)
  {
  }

  std::string make()
  {
    copy_header();
    for (const Element& element : m_elements)
      for (std::size_t i = 0; i < element.number; ++i)
        copy_record(element, i);
    return std::move(m_copy);
  }

private:
  std::string next_line()
  {
    const std::size_t end = m_bytes.find('\n', m_at);
    if (end == std::string::npos)
      throw Not_as_expected();
    std::string line = m_bytes.substr(m_at, end - m_at);
    m_at = end + 1;
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    return line;
  }

  void copy_header()
  {
    std::string line = next_line();
    if (line != "ply")
      throw Not_as_expected();
    for (; line != "end_header"; line = next_line()) {
      if (read_header_line(line))
        m_copy += line + "\n";
    }
    end_element();
    m_copy += "end_header\n";
    if (!m_has_faces)
      throw Not_as_expected();
  }

  /// Whether the line is kept.
  bool read_header_line(const std::string& line)
  {
    std::istringstream words(line);
    std::string word, name;
    words >> word;
    if (word == "format") {
      words >> name;
      m_format = name == "ascii"                  ? Ply_format::ASCII
                 : name == "binary_little_endian" ? Ply_format::LITTLE_ENDIAN_BYTES
                                                  : Ply_format::BIG_ENDIAN_BYTES;
    } else if (word == "element") {
      end_element();
      Element& element = m_elements.emplace_back();
      if (!(words >> element.name >> element.number))
        throw Not_as_expected();
    } else if (word == "property") {
      return read_property(words);
    }
    return true;
  }

  bool read_property(std::istringstream& words)
  {
    if (m_elements.empty())
      throw Not_as_expected();
    Property property;
    words >> property.type;
    if (property.type == "list")
      words >> property.count_type >> property.type;
    if (!(words >> property.name))
      throw Not_as_expected();
    m_elements.back().properties.push_back(property);
    return m_elements.back().name != "face" || !property.is_replaced();
  }

  /// After the last property of an element.
  void end_element()
  {
    if (m_elements.empty() || m_elements.back().name != "face")
      return;
    if (m_has_faces || m_elements.back().number != m_segment_of_face.size())
      throw Not_as_expected();
    m_has_faces = true;
    m_copy += "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int segment\n";
  }

  void copy_record(const Element& element, std::size_t i)
  {
    const bool is_face = element.name == "face";
    const char* separator = "";
    for (const Property& property : element.properties) {
      const std::string value = m_format == Ply_format::ASCII ? next_words(property) : next_value(property);
      if (is_face && property.is_replaced())
        continue;
      m_copy += (m_format == Ply_format::ASCII ? separator : "") + value;
      separator = " ";
    }
    if (is_face)
      append_segment(m_segment_of_face[i], separator);
    if (m_format == Ply_format::ASCII)
      m_copy += "\n";
  }

  std::string next_word()
  {
    const auto is_space = [](unsigned char c) { return std::isspace(c) != 0; };
    while (m_at < m_bytes.size() && is_space(m_bytes[m_at]))
      ++m_at;
    const std::size_t start = m_at;
    while (m_at < m_bytes.size() && !is_space(m_bytes[m_at]))
      ++m_at;
    if (m_at == start)
      throw Not_as_expected();
    return m_bytes.substr(start, m_at - start);
  }

  std::string next_words(const Property& property)
  {
    std::string words = next_word();
    if (!property.is_list())
      return words;
    for (unsigned long n = std::stoul(words); n > 0; --n)
      words += " " + next_word();
    return words;
  }

  std::string next_value(const Property& property)
  {
    const std::size_t start = m_at;
    std::size_t number = 1;
    if (property.is_list()) {
      number = read_count(property.count_type);
      m_at += size_of(property.count_type);
    }
    const std::size_t size = size_of(property.type);
    if (m_at > m_bytes.size() || number > (m_bytes.size() - m_at) / size)
      throw Not_as_expected();
    m_at += number * size;
    return m_bytes.substr(start, m_at - start);
  }

  std::size_t read_count(const std::string& type) const
  {
    const std::size_t size = size_of(type);
    if (m_at > m_bytes.size() || size > m_bytes.size() - m_at)
      throw Not_as_expected();
    const bool is_little_endian = m_format == Ply_format::LITTLE_ENDIAN_BYTES;
    const char* bytes = m_bytes.data() + m_at;
    return size == 1   ? read_bytes<std::uint8_t>(bytes, is_little_endian)
           : size == 2 ? read_bytes<std::uint16_t>(bytes, is_little_endian)
                       : read_bytes<std::uint32_t>(bytes, is_little_endian);
  }

  void append_segment(std::size_t segment, const char* separator)
  {
    for (std::uint8_t channel : segment_color(segment)) {
      m_copy += m_format == Ply_format::ASCII ? separator + std::to_string(channel) : std::string(1, char(channel));
      separator = " ";
    }
    if (m_format == Ply_format::ASCII) {
      m_copy += " " + std::to_string(segment);
      return;
    }
    std::string bytes;
    append_little_endian(bytes, std::int32_t(segment));
    if (m_format == Ply_format::BIG_ENDIAN_BYTES)
      std::reverse(bytes.begin(), bytes.end());
    m_copy += bytes;
  }

  const std::string& m_bytes;
  const std::vector<std::size_t>& m_segment_of_face;
  std::size_t m_at = 0;
  Ply_format m_format = Ply_format::ASCII;
  std::vector<Element> m_elements;
  bool m_has_faces = false;
  std::string m_copy;
};

} // namespace

std::optional<std::string> copy_ply(const std::string& bytes, const std::vector<std::size_t>& segment_of_face)
{
  try {
    return Ply_copy(bytes, segment_of_face).make();
  } catch (const std::logic_error&) { // a count that is no number
    return std::nullopt;
  } catch (const Not_as_expected&) {
    return std::nullopt;
  }
}

} // namespace segment_mesh
