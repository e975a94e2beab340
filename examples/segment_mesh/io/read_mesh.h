// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MESH_H

#include "io/Mesh_format.h"
#include "io/read_soup.h"
#include "soup/Polygon_soup.h"
#include "soup/link_corners.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace segment_mesh {

/// A mesh as its file has it, and as the segmentation takes it.
struct Input_mesh
{
  Polygon_soup soup; ///< faces in the order of the file: what labels and outputs refer to
  std::optional<Polygon_soup> other_soup;       ///< what is segmented, if it is not `soup`
  Corner_links links;                           ///< of `mesh_soup()`
  std::vector<std::size_t> mesh_face_of_face;   ///< for each face of `soup`, one of `mesh_soup()`
  std::vector<std::size_t> point_of_mesh_point; ///< for each of `mesh_soup()`, its place in `soup`
  Remarks remarks;

  /// What is segmented: an oriented 2-manifold, without points that no face uses.
  const Polygon_soup& mesh_soup() const { return other_soup ? *other_soup : soup; }
};

/// Reads a .off, .obj, .ply or .stl file, also one that gzip has compressed, or standard input for `-`. A mesh that is
/// not an oriented 2-manifold is repaired by \cgal's polygon soup functions, with a remark; the equal points of an
/// STL file are merged.
///
/// \param format if empty, the one that the ending names
/// \throws Input_error naming file, line if known, and cause
Input_mesh read_mesh(const std::string& file, std::optional<Mesh_format> format = std::nullopt);

/// The same for a soup that is in memory already; `name` stands for the file.
/// \throws Input_error if no face is left by repair
Input_mesh make_input_mesh(const std::string& name, Polygon_soup soup);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MESH_H
