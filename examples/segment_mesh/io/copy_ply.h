// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_COPY_PLY_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_COPY_PLY_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace segment_mesh {

/// A PLY file with the segment and the color of each face in place of the face properties red, green, blue and segment that it
/// may have. All else is kept, in its format: comments, other properties of vertices and faces, other elements.
/// \param bytes the whole file
/// \returns nothing if the bytes are not those of a PLY file with a face for each of `segment_of_face`
std::optional<std::string> copy_ply(const std::string& bytes, const std::vector<std::size_t>& segment_of_face);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_COPY_PLY_H
