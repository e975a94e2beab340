// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLY_HEADER_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLY_HEADER_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace segment_mesh {

enum class Ply_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

/// Bytes in a binary file.
std::size_t size_of(Ply_type type);
bool is_floating_point(Ply_type type);
/// The least and the greatest value of an integral type.
std::int64_t least(Ply_type type);
std::int64_t greatest(Ply_type type);

struct Ply_property
{
  std::string name;
  Ply_type type;
  bool is_list = false;
  Ply_type size_type = Ply_type::UINT8; ///< of a list
  bool is_coordinate = false;           ///< x, y or z of a vertex
  bool is_face = false;                 ///< the list of the vertices of a face
};

struct Ply_element
{
  std::string name;
  std::uint64_t count;
  std::size_t line;
  std::vector<Ply_property> properties;

  bool has_lists() const;
  /// Bytes of an item without lists in a binary file.
  std::size_t size_of_item() const;
};

/// The header of a PLY file.
struct Ply_header
{
  std::string format; ///< ascii, binary_little_endian or binary_big_endian
  std::vector<Ply_element> elements;
  std::uint64_t number_of_vertices = 0;
  std::uint64_t number_of_faces = 0;
  std::size_t number_of_lines = 0;
  std::size_t data_offset = 0;

  /// As \cgal's reader wants it: the format on line 2, nothing but elements and properties then.
  std::string text() const;
};

/// Reads the header, and checks that it has vertices and faces of types that \cgal reads.
/// \throws Input_error naming file, line and cause
Ply_header read_ply_header(const std::string& file, std::string_view bytes);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLY_HEADER_H
