// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TRIANGULATE_POLYGON_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TRIANGULATE_POLYGON_H

#include "soup/Polygon_soup.h"

#include <array>
#include <cstddef>
#include <vector>

namespace segment_mesh {

/// By three points each.
using Triangles = std::vector<std::array<Polygons::Index, 3>>;

/// Adds the triangles of a polygon, whose order of points they keep: ears in the plane of its
/// normal, and a fan where there is no ear, since it crosses itself, or where it has more than 1000
/// points left. O(n^3) at most, O(n^2) for a convex one.
void triangulate_polygon(const std::vector<Point>& points, const Polygon_soup::Polygon& polygon,
                         Triangles& triangles);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TRIANGULATE_POLYGON_H
