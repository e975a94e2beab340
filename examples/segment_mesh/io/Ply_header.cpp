// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Ply_header.h"

#include "io/Text_scanner.h"
#include "io/errors.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace segment_mesh {

namespace {

struct Type_traits
{
  Ply_type type;
  const char *name, *sized_name;
  std::size_t size;
  std::int64_t least, greatest;
};

template <typename T>
constexpr Type_traits integral(Ply_type type, const char* name, const char* sized_name)
{
  return {type,
          name,
          sized_name,
          sizeof(T),
          std::numeric_limits<T>::min(),
          std::numeric_limits<T>::max()};
}

constexpr Type_traits types[] = {integral<std::int8_t>(Ply_type::INT8, "char", "int8"),
                                 integral<std::uint8_t>(Ply_type::UINT8, "uchar", "uint8"),
                                 integral<std::int16_t>(Ply_type::INT16, "short", "int16"),
                                 integral<std::uint16_t>(Ply_type::UINT16, "ushort", "uint16"),
                                 integral<std::int32_t>(Ply_type::INT32, "int", "int32"),
                                 integral<std::uint32_t>(Ply_type::UINT32, "uint", "uint32"),
                                 {Ply_type::FLOAT32, "float", "float32", 4, 0, 0},
                                 {Ply_type::FLOAT64, "double", "float64", 8, 0, 0}};

const Type_traits& traits(Ply_type type)
{
  return types[std::size_t(type)];
}

Ply_type read_type(Text_scanner& scan)
{
  const std::string_view word = scan.word();
  const auto found = std::find_if(std::begin(types), std::end(types), [word](const Type_traits& t) {
    return word == t.name || word == t.sized_name;
  });
  if (found == std::end(types))
    scan.fail("unknown type of a property: " + in_quotes(word));
  return found->type;
}

bool is_vertex(const Ply_element& element)
{
  return element.name == "vertex" || element.name == "vertices";
}

bool is_face(const Ply_element& element)
{
  return element.name == "face" || element.name == "faces";
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

Ply_property read_property(Text_scanner& scan, const Ply_element& element)
{
  Ply_property property{};
  Text_scanner ahead = scan;
  property.is_list = ahead.word() == "list";
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

  const std::string& name = property.name;
  property.is_coordinate = is_vertex(element) && (name == "x" || name == "y" || name == "z");
  if (property.is_coordinate && (property.is_list || !is_floating_point(property.type)))
    scan.fail("property " + name + " is not a float or double");
  property.is_face = is_face(element) && (name == "vertex_indices" || name == "vertex_index");
  const bool is_index = property.type == Ply_type::INT32 || property.type == Ply_type::UINT32;
  if (property.is_face && !(property.is_list && is_index))
    scan.fail("property " + name + " is not a list of int or uint");
  return property;
}

void check_element(const std::string& file, const Ply_element& element)
{
  const auto count = [&element](auto which) {
    return std::count_if(element.properties.begin(), element.properties.end(), which);
  };
  if (element.count > 0 && element.properties.empty())
    throw Input_error(file, element.line,
                      "element " + in_quotes(element.name) + " has no properties");
  if (is_vertex(element) && count([](const Ply_property& p) { return p.is_coordinate; }) != 3)
    throw Input_error(file, element.line, "a vertex needs the properties x, y and z, once each");
  if (is_face(element) && count([](const Ply_property& p) { return p.is_face; }) != 1)
    throw Input_error(file, element.line, "a face needs the property vertex_indices, once");
}

void read_lines(Text_scanner& scan, Ply_header& header)
{
  if (!scan.next_line() || scan.word() != "ply" || scan.line_number() != 1)
    scan.fail("no PLY header");
  for (;;) {
    if (!scan.next_line())
      scan.fail("the file ends before 'end_header'");
    const std::string_view keyword = scan.word();
    if (keyword == "end_header")
      return;
    if (keyword == "format")
      header.format = std::string(scan.word());
    else if (keyword == "element")
      header.elements.push_back(read_element(scan));
    else if (keyword == "property" && !header.elements.empty())
      header.elements.back().properties.push_back(read_property(scan, header.elements.back()));
    else if (keyword != "comment" && keyword != "obj_info")
      scan.fail("unknown line of a PLY header: " + in_quotes(keyword));
  }
}

} // namespace

std::size_t size_of(Ply_type type)
{
  return traits(type).size;
}

bool is_floating_point(Ply_type type)
{
  return type == Ply_type::FLOAT32 || type == Ply_type::FLOAT64;
}

std::int64_t least(Ply_type type)
{
  return traits(type).least;
}

std::int64_t greatest(Ply_type type)
{
  return traits(type).greatest;
}

bool Ply_element::has_lists() const
{
  return std::any_of(properties.begin(), properties.end(),
                     [](const Ply_property& p) { return p.is_list; });
}

std::size_t Ply_element::size_of_item() const
{
  std::size_t size = 0;
  for (const Ply_property& property : properties)
    size += size_of(property.type);
  return size;
}

std::string Ply_header::text() const
{
  std::string text = "ply\nformat " + format + " 1.0\n";
  for (const Ply_element& element : elements) {
    // CGAL's reader expects certain properties of a halfedge, and skips elements that it does not
    // know.
    const bool is_known = is_vertex(element) || is_face(element);
    text +=
      "element " + (is_known ? element.name : "other") + " " + std::to_string(element.count) + "\n";
    for (const Ply_property& property : element.properties) {
      text += "property ";
      if (property.is_list)
        text += "list " + std::string(traits(property.size_type).name) + " ";
      text += std::string(traits(property.type).name) + " " + property.name + "\n";
    }
  }
  return text + "end_header\n";
}

Ply_header read_ply_header(const std::string& file, std::string_view bytes)
{
  Ply_header header;
  Text_scanner scan(file, bytes, Text_scanner::no_comments);
  read_lines(scan, header);
  header.number_of_lines = scan.line_number();
  header.data_offset = scan.offset_of_next_line();
  if (header.format != "ascii" && header.format != "binary_little_endian" &&
      header.format != "binary_big_endian")
    throw Input_error(file, "unknown format " + in_quotes(header.format) + " in the PLY header");

  for (const Ply_element& element : header.elements) {
    check_element(file, element);
    if (is_vertex(element))
      header.number_of_vertices += element.count;
    if (is_face(element))
      header.number_of_faces += element.count;
  }
  if (header.number_of_faces == 0)
    throw Input_error(file, "no faces");
  return header;
}

} // namespace segment_mesh
