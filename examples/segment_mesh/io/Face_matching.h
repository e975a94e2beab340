// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FACE_MATCHING_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FACE_MATCHING_H

#include "soup/Polygon_soup.h"

#include <cstddef>
#include <vector>

namespace segment_mesh {

/// Which faces of a file are which faces of its repaired mesh. Repair merges, splits and drops, but
/// leaves coordinates alone: points are matched by them, and faces by their sets of points.
struct Face_matching
{
  std::vector<std::size_t> mesh_face_of_face;
  std::vector<std::size_t> point_of_mesh_point;
  /// Faces that are not in the mesh, or that have a twin before them.
  std::size_t number_of_dropped_faces = 0;
};

/// A face that is not in `mesh_soup` is matched with a face there that shares an edge with it, else
/// a vertex, else with the one whose centroid is nearest. Where several do, with the first.
/// \pre every point of `mesh_soup` is one of `soup`; `mesh_soup` has a face
Face_matching match_faces(const Polygon_soup& soup, const Polygon_soup& mesh_soup);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FACE_MATCHING_H
