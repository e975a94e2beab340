// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LABELLED_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LABELLED_MESH_H

#include "soup/Polygon_soup.h"

#include <cstddef>
#include <vector>

namespace segment_mesh {

/// A mesh, or a part of it, with a segment for each face, `no_segment` for none.
struct Labelled_mesh
{
  const Polygon_soup& soup;
  const std::vector<std::size_t>& segment_of_face;
};

/// By segment, in their order; without those of no segment.
std::vector<std::vector<std::size_t>>
faces_of_segments(const std::vector<std::size_t>& segment_of_face, std::size_t number_of_segments);

/// Some faces, in their order, with their points in the order of the mesh. O(n log n) in their
/// corners.
Polygon_soup extract_faces(const Polygon_soup& soup, const std::vector<std::size_t>& faces);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LABELLED_MESH_H
