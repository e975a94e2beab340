// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MESH_H

#include "read/Mesh_format.h"
#include "read/errors.h"
#include "read/load_bytes.h"
#include "soup/Polygon_soup.h"

#include <optional>
#include <string>
#include <string_view>

namespace segment_mesh {

/// A mesh as its file has it: what is segmented, and what labels and outputs refer to.
struct Input_mesh
{
  Polygon_soup soup;
  Remarks remarks;
};

/// What is read beside a mesh: names of files, empty where there is none.
struct Side_files
{
  std::string labels; ///< if given, nothing is segmented
  std::string constraints, seeds;
};

/// Reads points and faces from the bytes of a file. \cgal's readers, which the tests compare these
/// with, give no line and no cause, accept some files that are short, and reserve the memory that a
/// count in the file promises. Here the memory is proportional to the size of `bytes`.
///
/// \param file the name for messages
/// \returns at least one face; indices are in range, coordinates finite, polygons have three
/// corners or more
/// \throws Input_error naming file, line (in a text file) and cause
Polygon_soup read_soup(const std::string& file, Mesh_format format, std::string_view bytes,
                       Remarks& remarks);

/// \name One function a format
/// @{
/// An item on each line, with colors, normals and textures, which are skipped; or a stream of words
/// as its header has it. Also with a `4OFF` header, and with the `OFF4 4 0` of some data sets.
/// Lines beyond the numbers of the header are skipped, with a remark.
Polygon_soup read_off(const std::string& file, std::string_view bytes, Remarks& remarks);
/// Statements that are not of the format are skipped, with a remark.
Polygon_soup read_obj(const std::string& file, std::string_view bytes, Remarks& remarks);
/// Text and binary of both orders of bytes, values of any type; elements and properties beside
/// those of vertices, faces and triangle strips (`tristrips`) are skipped; what is beyond the
/// numbers of the header, too, with a remark.
Polygon_soup read_ply(const std::string& file, std::string_view bytes, Remarks& remarks);
/// Text and binary; bytes beyond the number of a binary file are skipped, with a remark. Each
/// triangle has points of its own.
Polygon_soup read_stl(const std::string& file, std::string_view bytes, Remarks& remarks);
/// Text and binary: the triangles of the scene that is shown, as it places them. Buffers are in the
/// file, or in files of its folder.
Polygon_soup read_gltf(const std::string& file, std::string_view bytes, Remarks& remarks);
/// @}

/// Reads a .off, .obj, .ply, .stl, .glb or .gltf file, also one that gzip has compressed, or
/// standard input for `-`. Nothing is repaired; the equal points of STL and glTF files are merged.
///
/// \param format if empty, the one that the ending names
/// \throws Input_error naming file, line if known, and cause
inline Input_mesh read_mesh(const std::string& file,
                            std::optional<Mesh_format> format = std::nullopt)
{
  if (!format)
    format = mesh_format(file);
  Input_mesh input;
  const std::string bytes = load_bytes(file);
  input.soup = read_soup(file, *format, bytes, input.remarks);
  return input;
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MESH_H
