// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/Ply_header.h"

#include "read/errors.h"

#include <algorithm>
#include <iterator>
#include <type_traits>

namespace segment_mesh {

namespace {

struct Type_name
{
  const char *name, *sized_name;
};

/// In the order of `Ply_type`.
constexpr Type_name types[] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                               {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                               {"float", "float32"}, {"double", "float64"}};

/// In the order of `Ply_format`.
constexpr const char* formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};

Ply_type read_type(Text_scanner& scan)
{
  const std::string_view word = scan.word();
  const auto found = std::find_if(std::begin(types), std::end(types), [word](const Type_name& t) {
    return word == t.name || word == t.sized_name;
  });
  if (found == std::end(types))
    scan.fail("unknown type of a property: " + in_quotes(word));
  return Ply_type(found - std::begin(types));
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
  if (element.is_vertex() && property.size() == 1 && property >= "x" && property <= "z")
    return Ply_role(property[0] - 'x');
  const bool is_list_of_vertices = property == "vertex_indices" || property == "vertex_index";
  if (element.is_face() && is_list_of_vertices)
    return Ply_role::CORNERS;
  if (element.is_strips() && is_list_of_vertices)
    return Ply_role::STRIPS;
  return Ply_role::NONE;
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

  property.role = role_of(element, property.name);
  if (property.role == Ply_role::CORNERS || property.role == Ply_role::STRIPS) {
    if (!property.is_list || is_floating_point(property.type))
      scan.fail("property " + property.name + " is not a list of integers");
  } else if (property.role != Ply_role::NONE && property.is_list)
    scan.fail("property " + property.name + " is a list, not a number");
  return property;
}

Ply_format read_format(const std::string& file, const std::string& name)
{
  const auto found = std::find(std::begin(formats), std::end(formats), name);
  if (found == std::end(formats))
    throw Input_error(file, "unknown format " + in_quotes(name) + " in the PLY header");
  return Ply_format(found - std::begin(formats));
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
  if (element.is_strips() && count(Ply_role::STRIPS) != 1)
    throw Input_error(file, element.line, "triangle strips need the property vertex_indices, once");
}

/// \returns the name of the format
std::string read_lines(Text_scanner& scan, std::vector<Ply_element>& elements)
{
  if (!scan.next_line() || scan.word() != "ply" || scan.line_number() != 1)
    scan.fail("no PLY header");
  std::string format;
  for (;;) {
    if (!scan.next_line())
      scan.fail("the file ends before 'end_header'");
    const std::string_view keyword = scan.word();
    if (keyword == "end_header")
      return format;
    if (keyword == "format")
      format = std::string(scan.word());
    else if (keyword == "element")
      elements.push_back(read_element(scan));
    else if (keyword == "property" && !elements.empty())
      elements.back().properties.push_back(read_property(scan, elements.back()));
    else if (keyword != "comment" && keyword != "obj_info")
      scan.fail("unknown line of a PLY header: " + in_quotes(keyword));
  }
}

} // namespace

std::size_t size_of(Ply_type type)
{
  return with_type(type, [](auto value) { return sizeof value; });
}

bool is_floating_point(Ply_type type)
{
  return with_type(type, [](auto value) { return std::is_floating_point<decltype(value)>::value; });
}

std::string items_of(const Ply_element& element)
{
  return counted(std::size_t(element.count), "item") + " of element " + in_quotes(element.name);
}

std::string cut_off(const Ply_element& element, std::uint64_t item)
{
  return "the header promises " + items_of(element) + ", the file ends after " +
         std::to_string(item);
}

Ply_header read_ply_header(const std::string& file, Text_scanner& scan)
{
  Ply_header header{};
  header.format = read_format(file, read_lines(scan, header.elements));
  for (const Ply_element& element : header.elements) {
    check_element(file, element);
    if (element.is_vertex())
      header.number_of_vertices += element.count;
  }
  return header;
}

} // namespace segment_mesh
