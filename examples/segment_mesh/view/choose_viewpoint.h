// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_CHOOSE_VIEWPOINT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_CHOOSE_VIEWPOINT_H

#include "view/Scene.h"

#include <cstddef>
#include <vector>

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

/// The one of `candidate_viewpoints()` that shows the most: it has the largest sum over the
/// segments of the root of the visible area, so that many segments count more than a large one. The
/// same for the same input.
Viewpoint choose_viewpoint(const Scene& scene, const Up_direction& up = {});

/// The viewer stands at `azimuth` around the axis that is up, in degrees from the axis that follows
/// it, in the cyclic order x, y, z, toward the other one, and at `elevation` above. Where y is up,
/// the azimuth is measured from the z toward the x axis.
Viewpoint viewpoint_from(double azimuth, double elevation, const Up_direction& up = {});

/// Twelve directions round the object, from 15 and from 40 degrees above. What is up is given:
/// principal axes do not tell what stands (a person) from what lies (a fish).
std::vector<Viewpoint> candidate_viewpoints(const Up_direction& up = {});

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_CHOOSE_VIEWPOINT_H
