// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SPLIT_PINCHED_POLYGONS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SPLIT_PINCHED_POLYGONS_H

#include <cstddef>
#include <vector>

namespace segment_mesh {

/// Makes polygons without repeated corners: of equal corners in succession one stays, and a polygon
/// that comes to a point again is split there. The first piece takes the place of the polygon, the
/// others follow behind all polygons. Pieces may have one or two corners.
///
/// In linear time. The step of \cgal's `repair_polygon_soup()` that does the same begins the rest
/// of a polygon anew after each split: one of 300,000 corners on three points takes it 20 s.
/// \pre equal points have the same index; indices are below `number_of_points`
void split_pinched_polygons(std::size_t number_of_points,
                            std::vector<std::vector<std::size_t>>& polygons);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SPLIT_PINCHED_POLYGONS_H
