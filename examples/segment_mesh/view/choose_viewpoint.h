// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_CHOOSE_VIEWPOINT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_CHOOSE_VIEWPOINT_H

#include "soup/Polygon_soup.h"
#include "view/Scene.h"
#include "view/Viewpoint.h"

#include <cstddef>
#include <vector>

namespace segment_mesh {

/// The viewpoint, of a fixed set of them, that shows the most: it has the largest sum over the
/// segments of the root of the visible area, so that many segments count more than a large one. The
/// same for the same input. See `candidate_viewpoints()`.
Viewpoint choose_viewpoint(const Scene& scene);
Viewpoint choose_viewpoint(const Polygon_soup& soup, const std::vector<std::size_t>& labels);

/// The viewer stands at `azimuth` around the y axis, from the z toward the x axis, and at
/// `elevation` above; in degrees.
Viewpoint viewpoint_from(double azimuth, double elevation);

/// Twelve directions round the object, from 15 and from 40 degrees above. Up is the y axis of the
/// file, as in most formats and in the Princeton benchmark: principal axes do not tell what stands
/// (a person) from what lies (a fish).
std::vector<Viewpoint> candidate_viewpoints();

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_CHOOSE_VIEWPOINT_H
