// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LIGHT_CORNERS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LIGHT_CORNERS_H

#include "view/Scene.h"
#include "view/Viewpoint.h"

#include <vector>

namespace segment_mesh {

/// The light on each corner of each face, in the order of `Scene::corners`: 1 shows a color as it
/// is, 0 is black, 2 would be white. The surface looks smooth, but for edges that are sharp; both
/// of its sides are lit, so a face that is turned the wrong way does not show.
std::vector<float> light_corners(const Scene& scene, const Viewpoint& viewpoint);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LIGHT_CORNERS_H
