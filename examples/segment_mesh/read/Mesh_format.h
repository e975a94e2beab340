// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MESH_FORMAT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MESH_FORMAT_H

#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

/// The last ending of the name of a file, without the dot, in lower case.
std::string ending_of(const std::string& file);

/// As a sentence lists them: ".a, .b or .c".
std::string list_of_endings(const std::vector<std::string>& endings);

/// The formats that are read.
enum class Mesh_format { OFF, OBJ, PLY, STL, GLTF };

/// The name of a file that stands for standard input.
constexpr const char* standard_input = "-";

/// The formats by the words for them, which are the endings of their files.
const std::vector<std::pair<std::string, Mesh_format>>& mesh_formats();

/// These words, as a sentence lists endings.
std::string endings_of_meshes();

/// The format that the ending of `file` names, in upper or lower case, before `.gz` if there is
/// one. \throws Input_error for another ending, and for standard input
Mesh_format mesh_format(const std::string& file);

/// Whether the ending is `.gz`.
bool is_compressed(const std::string& file);

/// The name of an input without folder and endings, `stdin` for standard input: what `{stem}`
/// stands for.
std::string stem_of_input(const std::string& file);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MESH_FORMAT_H
