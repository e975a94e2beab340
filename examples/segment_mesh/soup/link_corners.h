// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IS_ORIENTED_MANIFOLD_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IS_ORIENTED_MANIFOLD_H

#include "soup/Polygon_soup.h"

namespace segment_mesh {

/// Whether the faces form an oriented 2-manifold: faces have at least three corners, none twice; no
/// two faces have an edge in the same direction; the faces at a point form one fan or one disc.
///
/// The answer of \cgal's `is_polygon_soup_a_polygon_mesh()`, which takes longer than the reading of
/// a file: it sorts all edges in a tree. O(C log d), where C is the number of corners and d the
/// largest number of faces at a point.
bool is_oriented_manifold(const Polygon_soup& soup);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IS_ORIENTED_MANIFOLD_H
