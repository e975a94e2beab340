// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SMOOTH_BORDERS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SMOOTH_BORDERS_H

#include "segmentation/run_segmentation.h"

namespace segment_mesh {

/// Moves the borders between the segments by minimum cuts, on `make_manifold()` of the soup. A face
/// that changed its segment gets the region of the nearest face, across edges, that stayed in that
/// segment, so that again every region lies in one segment.
void smooth_borders(const Polygon_soup& soup, const Marks& marks, const Progress_listener& listener,
                    Segmentation& segmentation);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SMOOTH_BORDERS_H
