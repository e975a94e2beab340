// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SCENE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SCENE_H

#include "soup/Polygon_soup.h"

#include <cstddef>
#include <vector>

namespace segment_mesh {

/// What is drawn of a soup: its faces, with the points moved and scaled into the unit ball, so that
/// neither the size of the mesh nor its place matters.
struct Scene
{
  Polygon_soup soup;               ///< points without a face are at the origin
  std::vector<std::size_t> labels; ///< of each face
  Point center = {0, 0, 0};        ///< in the soup
  double radius = 0;               ///< in the soup
};

/// \pre there are a label for each face and a finite point for each corner
Scene make_scene(const Polygon_soup& soup, const std::vector<std::size_t>& labels);

/// Moves points between two borders, where the surface is smooth, along the surface, so that
/// borders do not zigzag from edge to edge.
void smooth_borders(Scene& scene);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SCENE_H
