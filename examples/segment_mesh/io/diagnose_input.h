// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_DIAGNOSE_INPUT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_DIAGNOSE_INPUT_H

#include <string>

namespace segment_mesh {

/// The formats that are read.
enum class Mesh_format { OFF, OBJ, PLY, STL };

/// The format that the ending of `file` names, in upper or lower case.
/// \throws Input_error for another ending
Mesh_format mesh_format(const std::string& file);

/// The bytes of a regular file that is not empty.
/// \throws Input_error
std::string load_file(const std::string& file);

/// Looks for all that makes a file unreadable before \cgal's reader sees it. \cgal's readers only
/// say no, without a line and a cause; some files they accept although they are short, or reserve
/// the memory that a count in the file promises, or index past what a line holds.
///
/// \param file the name for messages
/// \param bytes what the file holds
/// \returns what \cgal's reader is to read: the same mesh, without statements, colors and header
///          lines that it stumbles over
/// \throws Input_error naming file, line (in a text file) and cause
std::string diagnose_input(const std::string& file, Mesh_format format, std::string bytes);

/// \name One function a format
/// @{
std::string diagnose_off(const std::string& file, std::string bytes);
std::string diagnose_obj(const std::string& file, const std::string& bytes);
std::string diagnose_ply(const std::string& file, const std::string& bytes);
std::string diagnose_stl(const std::string& file, std::string bytes);
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_DIAGNOSE_INPUT_H
