// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_SOUP_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_SOUP_H

#include "read/Mesh_format.h"
#include "read/errors.h"
#include "soup/Polygon_soup.h"

#include <string>
#include <string_view>

namespace segment_mesh {

/// Reads points and faces from the bytes of a file, in one pass. \cgal's readers, which the tests
/// compare these with, give no line and no cause, accept some files that are short, and reserve the
/// memory that a count in the file promises. Here the memory is proportional to the size of
/// `bytes`.
///
/// \param file the name for messages
/// \returns at least one face; indices are in range, coordinates finite, polygons have three
/// corners or more
/// \throws Input_error naming file, line (in a text file) and cause
Polygon_soup read_soup(const std::string& file, Mesh_format format, std::string_view bytes,
                       Remarks& remarks);

/// \name One function a format
/// @{
/// Also with a `4OFF` header, and with the `OFF4 4 0` of some data sets; colors, normals and
/// textures are skipped; lines beyond the numbers of the header, too, with a remark.
Polygon_soup read_off(const std::string& file, std::string_view bytes, Remarks& remarks);
/// Statements that are not of the format are skipped, with a remark.
Polygon_soup read_obj(const std::string& file, std::string_view bytes, Remarks& remarks);
/// Text and binary of both orders of bytes, values of any type; elements and properties beside
/// those of vertices, faces and triangle strips (`tristrips`) are skipped; what is beyond the
/// numbers of the header, too, with a remark.
Polygon_soup read_ply(const std::string& file, std::string_view bytes, Remarks& remarks);
/// Text and binary; equal points are merged into the first of them; bytes beyond the number of a
/// binary file are skipped, with a remark.
Polygon_soup read_stl(const std::string& file, std::string_view bytes, Remarks& remarks);
/// Text and binary: the triangles of the scene that is shown, as it places them; equal points are
/// merged into the first of them. Buffers are in the file, or in files of its folder.
Polygon_soup read_gltf(const std::string& file, std::string_view bytes, Remarks& remarks);
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_SOUP_H
