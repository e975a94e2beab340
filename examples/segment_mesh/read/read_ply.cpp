// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/Text_scanner.h"
#include "read/errors.h"
#include "read/read_mesh.h"
#include "soup/little_endian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

namespace segment_mesh {

namespace {

/// What the reader makes of a property.
enum class Ply_role { X, Y, Z, RED, GREEN, BLUE, U, V, CORNERS, TEXTURE, NONE };

struct Ply_property
{
  std::string name;
  Number_type type;
  bool is_list = false;
  Number_type size_type = Number_type::UINT8; ///< of a list
  Ply_role role = Ply_role::NONE;
};

struct Ply_element
{
  std::string name;
  std::uint64_t count;
  std::size_t line;
  std::vector<Ply_property> properties;

  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool is_face() const { return name == "face" || name == "faces"; }
  bool has(Ply_role role) const
  {
    return std::any_of(properties.begin(), properties.end(),
                       [role](const Ply_property& p) { return p.role == role; });
  }
};

struct Ply_header
{
  std::size_t format; // 0: text; 1 and 2: binary, little and big endian
  std::vector<Ply_element> elements;
  std::uint64_t number_of_vertices = 0;
  std::vector<std::string> textures; // files, of comments
};

/// Of a vertex or a triangle in binary with numbers of one byte.
constexpr std::size_t least_item_size = 3;

/// The names of formats, in the order of their numbers.
constexpr const char* formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};

/// The two names of each type, in the order of `Number_type`.
constexpr const char* types[][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                    {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                    {"float", "float32"}, {"double", "float64"}};

/// "4 items of element 'face'".
std::string items_of(const Ply_element& element)
{
  return counted(std::size_t(element.count), "item") + " of element " + in_quotes(element.name);
}

Number_type read_type(Text_scanner& scan)
{
  const std::string_view word = scan.word();
  const auto found = std::find_if(std::begin(types), std::end(types), [word](const auto& names) {
    return is_word(word, names[0]) || is_word(word, names[1]);
  });
  if (found == std::end(types))
    scan.fail("unknown type of a property: " + in_quotes(word));
  return Number_type(found - std::begin(types));
}

Ply_element read_element(Text_scanner& scan)
{
  Ply_element element{std::string(scan.word()), 0, scan.line_number(), {}};
  const std::int64_t count = scan.integer(scan.word(), "a number of items");
  if (count < 0)
    scan.fail(std::to_string(count) + " is not a number of items");
  element.count = std::uint64_t(count);
  return element;
}

Ply_role role_of(const Ply_element& element, const std::string& property)
{
  if (element.is_vertex()) {
    const std::pair<const char*, Ply_role> roles[] = {
      {"x", Ply_role::X},     {"y", Ply_role::Y},         {"z", Ply_role::Z},
      {"red", Ply_role::RED}, {"green", Ply_role::GREEN}, {"blue", Ply_role::BLUE},
      {"u", Ply_role::U},     {"v", Ply_role::V},         {"s", Ply_role::U},
      {"t", Ply_role::V},     {"texture_u", Ply_role::U}, {"texture_v", Ply_role::V}};
    for (const auto& [name, role] : roles)
      if (property == name)
        return role;
  }
  if (element.is_face() && property == "texcoord")
    return Ply_role::TEXTURE;
  if (element.is_face() && (property == "vertex_indices" || property == "vertex_index"))
    return Ply_role::CORNERS;
  return Ply_role::NONE;
}

Ply_property read_property(Text_scanner& scan, const Ply_element& element)
{
  Ply_property property{};
  Text_scanner ahead = scan;
  property.is_list = is_word(ahead.word(), "list");
  if (property.is_list) {
    scan = ahead;
    property.size_type = read_type(scan);
    if (is_floating_point(property.size_type))
      scan.fail("a list whose size is not an integer");
  }
  property.type = read_type(scan);
  property.name = std::string(scan.word());
  if (property.name.empty())
    scan.fail("a property without a name");

  property.role = role_of(element, property.name);
  const bool is_coordinate = property.role <= Ply_role::Z;
  if ((property.role < Ply_role::CORNERS && !is_coordinate && property.is_list) ||
      (property.role == Ply_role::TEXTURE && !property.is_list))
    property.role = Ply_role::NONE;
  if (property.role == Ply_role::CORNERS) {
    if (!property.is_list || is_floating_point(property.type))
      scan.fail("property " + property.name + " is not a list of integers");
  } else if (is_coordinate && property.is_list)
    scan.fail("property " + property.name + " is a list, not a number");
  return property;
}

void check_element(const std::string& file, const Ply_element& element)
{
  const auto count = [&element](Ply_role role) {
    return std::count_if(element.properties.begin(), element.properties.end(),
                         [role](const Ply_property& p) { return p.role == role; });
  };
  if (element.count > 0 && element.properties.empty())
    throw Input_error(file, element.line,
                      "element " + in_quotes(element.name) + " has no properties");
  if (element.is_vertex() &&
      !(count(Ply_role::X) == 1 && count(Ply_role::Y) == 1 && count(Ply_role::Z) == 1))
    throw Input_error(file, element.line, "a vertex needs the properties x, y and z, once each");
  if (element.is_face() && count(Ply_role::CORNERS) != 1)
    throw Input_error(file, element.line, "a face needs the property vertex_indices, once");
}

/// Reads the header, and checks that there are what vertices and faces need.
/// \param scan at the start of the file; left at the last line of the header
Ply_header read_header(const std::string& file, Text_scanner& scan)
{
  if (!scan.next_line() || !is_word(scan.word(), "ply") || scan.line_number() != 1)
    scan.fail("no PLY header");
  Ply_header header{};
  std::vector<Ply_element>& elements = header.elements;
  std::string format;
  for (;;) {
    if (!scan.next_line())
      scan.fail("the file ends before 'end_header'");
    const std::string_view keyword = scan.word();
    if (is_word(keyword, "end_header"))
      break;
    if (is_word(keyword, "format"))
      format = std::string(scan.word());
    else if (is_word(keyword, "element"))
      elements.push_back(read_element(scan));
    else if (is_word(keyword, "property") && !elements.empty())
      elements.back().properties.push_back(read_property(scan, elements.back()));
    else if (is_word(keyword, "comment")) {
      if (is_word(scan.word(), "texturefile"))
        header.textures.emplace_back(scan.rest_of_line());
    } else if (!is_word(keyword, "obj_info"))
      scan.fail("unknown line of a PLY header: " + in_quotes(keyword));
  }
  const auto found = std::find_if(std::begin(formats), std::end(formats),
                                  [&format](const char* name) { return is_word(format, name); });
  if (found == std::end(formats))
    throw Input_error(file, "unknown format " + in_quotes(format) + " in the PLY header");
  header.format = std::size_t(found - std::begin(formats));
  for (const Ply_element& element : elements) {
    check_element(file, element);
    if (element.is_vertex())
      header.number_of_vertices += element.count;
  }
  return header;
}

/// What follows the header. \param start where the line after the header starts
std::string_view data_after_header(std::string_view bytes, std::size_t start)
{
  // Where lines end with a carriage return alone, a line feed after the header is data.
  const std::size_t end_of_line = bytes.find_first_of("\r\n");
  const bool has_returns_alone = bytes.substr(end_of_line, 2) != "\r\n" &&
                                 bytes[end_of_line] == '\r';
  if (has_returns_alone && bytes.substr(start - 2, 2) == "\r\n")
    --start;
  return bytes.substr(start);
}

/// Reads the data of a file. Items of a text may span lines.
class Ply_reader
{
public:
  Ply_reader(const std::string& file, std::string_view bytes)
    : m_file(file)
    , m_scan(file, bytes, Text_scanner::no_comments)
    , m_header(read_header(file, m_scan))
    , m_is_text(m_header.format == 0)
    , m_data(data_after_header(bytes, m_scan.offset_of_next_line()))
  {}

  Input_mesh read()
  {
    for (const Ply_element& element : m_header.elements) {
      m_element = &element;
      reserve(element);
      const bool is_vertex = element.is_vertex(), has_colors = element.has(Ply_role::RED),
                 has_texture = element.has(Ply_role::U) || element.has(Ply_role::TEXTURE);
      for (m_item = 0; m_item < element.count; ++m_item) {
        for (const Ply_property& property : element.properties)
          read_property(property);
        if (is_vertex)
          end_vertex(has_colors, has_texture);
        else if (has_texture)
          end_face();
      }
    }
    const bool has_more = m_is_text ? m_scan.has_word() || m_scan.next_line() : !m_data.empty();
    if (has_more && !m_soup.polygons.empty())
      m_input.remarks.push_back(
        (m_is_text ? m_scan.not_read() : bytes_not_read(m_file, m_data.size()) + " at the end") +
        ": the header promises " + items_of(m_header.elements.back()));
    if (!m_header.textures.empty())
      m_input.properties.library = std::make_shared<Material_library>(Material_library{
        std::filesystem::path(m_file).parent_path().string(), {}, m_header.textures, {}, {}});
    return std::move(m_input);
  }

private:
  [[noreturn]] void fail(const std::string& cause) const
  {
    if (m_is_text)
      m_scan.fail(cause);
    throw Input_error(m_file, "item " + std::to_string(m_item) + " of element " +
                                in_quotes(m_element->name) + ", from 0: " + cause);
  }

  [[noreturn]] void fail_cut_off() const
  {
    const std::string cause = "the header promises " + items_of(*m_element) +
                              ", the file ends after " + std::to_string(m_item);
    if (m_is_text)
      m_scan.fail(cause);
    throw Input_error(m_file, cause);
  }

  /// Memory for the items that the header promises and the file has room for.
  void reserve(const Ply_element& element)
  {
    const std::size_t available = m_is_text ? m_scan.available() : m_data.size(),
                      size((std::min)(element.count, std::uint64_t(available / least_item_size)));
    if (element.is_vertex())
      m_soup.points.reserve(m_soup.points.size() + size);
    if (element.is_face())
      m_soup.polygons.reserve(m_soup.polygons.size() + size);
  }

  std::string_view word()
  {
    const std::string_view result = m_scan.word_of_any_line();
    if (result.empty())
      fail_cut_off();
    return result;
  }

  /// A value of binary data.
  template <typename Result>
  Result take(Number_type type)
  {
    return with_type(type, [this](auto zero) {
      using Value = decltype(zero);
      if (m_data.size() < sizeof(Value))
        fail_cut_off();
      const Value value = m_header.format == 1
                            ? read_bytes<Value>(m_data.data())
                            : read_bytes<Value, boost::endian::order::big>(m_data.data());
      m_data.remove_prefix(sizeof(Value));
      return Result(value);
    });
  }

  /// \pre the type is an integer
  std::int64_t integer(Number_type type)
  {
    if (!m_is_text)
      return take<std::int64_t>(type);
    const std::int64_t value = m_scan.integer(word(), "an integer");
    const bool is_in_range = with_type(type, [value](auto zero) {
      using Limits = std::numeric_limits<decltype(zero)>;
      return value >= std::int64_t((Limits::min)()) && value <= std::int64_t((Limits::max)());
    });
    if (!is_in_range)
      fail(std::to_string(value) + " is out of the range of its type");
    return value;
  }

  /// Of a color or texture: 0 where it is not a finite number.
  double number(const Ply_property& property)
  {
    return m_is_text ? number_or_zero(word()) : usable_value(take<double>(property.type));
  }

  double coordinate(const Ply_property& property)
  {
    if (!is_floating_point(property.type))
      return double(integer(property.type));
    double value = m_is_text ? m_scan.finite_number(word()) : take<double>(property.type);
    if (property.type == Number_type::FLOAT32)
      value = float(value);
    if (!std::isfinite(value))
      fail(property.name + " is not a finite number");
    return value;
  }

  void skip(Number_type type, std::uint64_t number)
  {
    for (std::uint64_t i = 0; m_is_text && i < number; ++i)
      word();
    if (m_is_text)
      return;
    if (m_data.size() / size_of(type) < number)
      fail_cut_off();
    m_data.remove_prefix(std::size_t(number) * size_of(type));
  }

  void read_property(const Ply_property& property)
  {
    const std::int64_t size = property.is_list ? integer(property.size_type) : 1;
    if (property.role == Ply_role::CORNERS)
      read_face(property.type, size);
    else if (size < 0)
      fail("a list of " + std::to_string(size) + " values");
    else if (property.role == Ply_role::TEXTURE)
      for (std::int64_t i = 0; i < size; ++i)
        m_texture.push_back(number(property));
    else if (property.role == Ply_role::NONE)
      skip(property.type, std::uint64_t(size));
    else
      m_values[std::size_t(property.role)] = property.role <= Ply_role::Z
                                               ? coordinate(property)
                                               : number(property) / largest_color(property);
  }

  /// What is 1 of a color; 1 of other values.
  static double largest_color(const Ply_property& property)
  {
    const bool is_color = property.role >= Ply_role::RED && property.role <= Ply_role::BLUE;
    return !is_color || is_floating_point(property.type) ? 1
           : size_of(property.type) == 1                 ? 255
                                                         : 65535;
  }

  void end_vertex(bool has_colors, bool has_texture)
  {
    const auto& [x, y, z, red, green, blue, u, v] = m_values;
    m_soup.points.push_back({x, y, z});
    if (has_colors)
      m_input.properties.colors.values.push_back({float(red), float(green), float(blue)});
    if (has_texture)
      m_input.properties.texture.values.push_back({u, v});
  }

  /// Of a face with texture coordinates: two numbers for each corner.
  void end_face()
  {
    auto& [values, of_corner] = m_input.properties.texture;
    const std::size_t end = m_soup.polygons.corners().size(),
                      first = m_soup.polygons.first_corner(m_soup.polygons.size() - 1);
    of_corner.resize(end, Corner_values<double>::none);
    for (std::size_t i = 0; first + i < end && 2 * i + 1 < m_texture.size(); ++i) {
      of_corner[first + i] = Polygons::Index(values.size());
      values.push_back({m_texture[2 * i], m_texture[2 * i + 1]});
    }
    m_texture.clear();
  }

  void read_face(Number_type type, std::int64_t size)
  {
    if (size < 3)
      fail("a face with " + std::to_string(size) + " vertices, fewer than 3");
    for (std::int64_t i = 0; i < size; ++i)
      m_soup.polygons.add_corner(checked(integer(type)));
    m_soup.polygons.close_polygon();
  }

  std::size_t checked(std::int64_t index) const
  {
    if (index < 0 || std::uint64_t(index) >= m_header.number_of_vertices)
      fail(out_of_range(index, std::size_t(m_header.number_of_vertices), "vertex", 0));
    return std::size_t(index);
  }

  const std::string& m_file;
  Text_scanner m_scan;
  const Ply_header m_header;
  const bool m_is_text;
  std::string_view m_data; // of a binary file
  const Ply_element* m_element = nullptr;
  std::uint64_t m_item = 0; // of that element, which is read
  Input_mesh m_input;
  Polygon_soup& m_soup = m_input.soup;
  std::array<double, 8> m_values{}; // of a vertex, by `Ply_role`
  std::vector<double> m_texture;    // of a face
};

} // namespace

Input_mesh read_ply(const std::string& file, std::string_view bytes)
{
  return Ply_reader(file, bytes).read();
}

} // namespace segment_mesh
