// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLY_HEADER_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLY_HEADER_H

#include "read/Text_scanner.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace segment_mesh {

enum class Ply_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

/// Calls `f` with a value of the type.
template <typename Function>
decltype(auto) with_type(Ply_type type, Function f)
{
  switch (type) {
  case Ply_type::INT8:
    return f(std::int8_t());
  case Ply_type::UINT8:
    return f(std::uint8_t());
  case Ply_type::INT16:
    return f(std::int16_t());
  case Ply_type::UINT16:
    return f(std::uint16_t());
  case Ply_type::INT32:
    return f(std::int32_t());
  case Ply_type::UINT32:
    return f(std::uint32_t());
  case Ply_type::FLOAT32:
    return f(float());
  default:
    return f(double());
  }
}

/// Bytes in a binary file.
std::size_t size_of(Ply_type type);
bool is_floating_point(Ply_type type);

/// What the reader makes of a property.
enum class Ply_role { X, Y, Z, CORNERS, STRIPS, NONE };

struct Ply_property
{
  std::string name;
  Ply_type type;
  bool is_list = false;
  Ply_type size_type = Ply_type::UINT8; ///< of a list
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
  bool is_strips() const { return name == "tristrips"; }
};

enum class Ply_format { ASCII, BINARY_LITTLE_ENDIAN, BINARY_BIG_ENDIAN };

/// The header of a PLY file.
struct Ply_header
{
  Ply_format format;
  std::vector<Ply_element> elements;
  std::uint64_t number_of_vertices = 0;
};

/// "4 items of element 'face'".
std::string items_of(const Ply_element& element);
/// What is wrong with a file that ends within an item.
std::string cut_off(const Ply_element& element, std::uint64_t item);

/// Reads the header, and checks that there are what vertices, faces and triangle strips need.
/// \param scan at the start of the file; left at its last line
/// \throws Input_error naming file, line and cause
Ply_header read_ply_header(const std::string& file, Text_scanner& scan);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLY_HEADER_H
