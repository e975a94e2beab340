// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SCENE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SCENE_H

#include "soup/Polygon_soup.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace segment_mesh {

/// What is drawn of a soup: the faces that can be, in flat arrays, moved and scaled into the unit
/// ball, so that neither the size of the mesh nor its place matters.
struct Scene
{
  using Index = std::uint32_t;

  std::vector<Point> points;
  std::vector<Index> first_corners; ///< of each face, and the end of the last one
  std::vector<Index> corners;       ///< indices of points, the same as in the soup
  std::vector<std::size_t> labels;  ///< of each face
  std::vector<Point> area_vectors;  ///< of each face: along its normal, as long as twice its area
  std::vector<char> is_used;        ///< for each point: a face has it

  std::size_t number_of_faces() const { return labels.size(); }
};

/// Faces with fewer than three corners, or with a point that is not finite, are left out.
/// \throws std::invalid_argument unless there is a label for each face and a point for each corner
Scene make_scene(const Polygon_soup& soup, const std::vector<std::size_t>& labels);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SCENE_H
