// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MESH_H

#include "read/Mesh_format.h"
#include "read/read_soup.h"
#include "soup/Polygon_soup.h"

#include <optional>
#include <string>

namespace segment_mesh {

/// A mesh as its file has it: what is segmented, and what labels and outputs refer to.
struct Input_mesh
{
  Polygon_soup soup;
  Remarks remarks;
};

/// Reads a .off, .obj, .ply, .stl, .glb or .gltf file, also one that gzip has compressed, or
/// standard input for `-`. Nothing is repaired; the equal points of STL and glTF files are merged.
///
/// \param format if empty, the one that the ending names
/// \throws Input_error naming file, line if known, and cause
Input_mesh read_mesh(const std::string& file, std::optional<Mesh_format> format = std::nullopt);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MESH_H
