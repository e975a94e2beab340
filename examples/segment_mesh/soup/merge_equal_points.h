// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MERGE_EQUAL_POINTS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MERGE_EQUAL_POINTS_H

#include "soup/Polygon_soup.h"

namespace segment_mesh {

/// Of points with the same coordinates keeps the first; those that are kept stay in order. O(n log
/// n), by sorting. \pre coordinates are finite
void merge_equal_points(Polygon_soup& soup);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MERGE_EQUAL_POINTS_H
