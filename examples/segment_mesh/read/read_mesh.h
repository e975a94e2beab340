// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MESH_H

#include "read/errors.h"
#include "read/load_bytes.h"
#include "soup/Mesh_properties.h"
#include "soup/Polygon_soup.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace segment_mesh {

/// The last ending of the name of a file, without the dot, in lower case.
std::string ending_of(const std::string& file);

/// As a sentence lists them: ".a, .b or .c".
std::string list_of_endings(const std::vector<std::string>& endings);

/// The formats that are read.
enum class Mesh_format { OFF, OBJ, PLY, STL, GLTF, THREE_MF };

/// The name of a file that stands for standard input.
constexpr const char* standard_input = "-";

/// The formats by the words for them, which are the endings of their files.
const std::vector<std::pair<std::string, Mesh_format>>& mesh_formats();

/// These words, as a sentence lists endings.
std::string endings_of_meshes();

/// The format that the ending of `file` names, in upper or lower case, before `.gz` if there is
/// one. \throws Input_error for another ending, and for standard input
Mesh_format mesh_format(const std::string& file);

/// The name of an input without folder and endings, `stdin` for standard input: what `{stem}`
/// stands for.
std::string stem_of_input(const std::string& file);

/// A mesh as its file has it: what is segmented, and what labels and outputs refer to.
struct Input_mesh
{
  Polygon_soup soup;
  Mesh_properties properties;
  Remarks remarks;
};

/// What is read beside a mesh: names of files, empty where there is none, and kinds of sets of its
/// own.
struct Side_files
{
  std::string labels; ///< if given, nothing is segmented
  std::string constraints, seeds;
  std::optional<Set_kind> labels_from;      ///< in place of `labels`
  std::optional<Set_kind> constraints_from; ///< whose borders are constraints

  bool has_labels() const { return labels_from || !labels.empty(); }
};

/// Reads points and faces from the bytes of a file. \cgal's readers, which the tests compare these
/// with, give no line and no cause, accept some files that are short, and reserve the memory that a
/// count in the file promises. Here the memory is proportional to the size of `bytes`.
///
/// \param file the name for messages
/// \returns at least one face; indices are in range, coordinates finite, polygons have three
/// corners or more
/// \throws Input_error naming file, line (in a text file) and cause
Input_mesh parse_mesh(const std::string& file, Mesh_format format, std::string_view bytes);

/// \name One function a format
/// @{
/// An item on each line, or a stream of words; normals, colors and textures are skipped. Also with
/// the `OFF4 4 0` of some data sets. Lines beyond the numbers of the header are skipped, with a
/// remark.
Input_mesh read_off(const std::string& file, std::string_view bytes);
/// Statements that are not of the format are skipped, with a remark.
Input_mesh read_obj(const std::string& file, std::string_view bytes);
/// Text and binary of both orders of bytes, values of any type; elements and properties beside
/// those of vertices and faces are skipped; what is beyond the numbers of the header, too, with a
/// remark.
Input_mesh read_ply(const std::string& file, std::string_view bytes);
/// Text and binary; bytes beyond the number of a binary file are skipped, with a remark. Each
/// triangle has points of its own.
Input_mesh read_stl(const std::string& file, std::string_view bytes);
/// Text and binary: the triangles of the scene that is shown, as it places them. Buffers are in the
/// file, or in files of its folder.
Input_mesh read_gltf(const std::string& file, std::string_view bytes);
/// The items of the build, also with components in other files of the archive. A triangle that is
/// painted in several colors has the one of most of it, with a remark.
Input_mesh read_3mf(const std::string& file, std::string_view bytes);
/// @}

/// Reads a .off, .obj, .ply, .stl, .glb, .gltf or .3mf file, also one that gzip has compressed, or
/// standard input for `-`. Nothing is repaired; the equal points of STL, glTF and 3MF files are
/// merged.
///
/// \param format if empty, the one that the ending names
/// \throws Input_error naming file, line if known, and cause
inline Input_mesh read_mesh(const std::string& file,
                            std::optional<Mesh_format> format = std::nullopt)
{
  if (!format)
    format = mesh_format(file);
  return parse_mesh(file, *format, load_bytes(file));
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MESH_H
