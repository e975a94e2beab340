// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_VIEWPOINT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_VIEWPOINT_H

#include "soup/Polygon_soup.h"

#include <cstddef>

namespace segment_mesh {

/// From where a mesh is seen, without perspective: three unit vectors in space, orthogonal to each
/// other and right-handed.
struct Viewpoint
{
  Point right, up, toward_viewer;
};

/// The direction of the mesh that is up in pictures: that of an axis, or opposite to it.
struct Up_direction
{
  std::size_t axis = 1; ///< y, as in most formats
  double sign = 1;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_VIEWPOINT_H
