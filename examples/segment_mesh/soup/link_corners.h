// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LINK_CORNERS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LINK_CORNERS_H

#include "soup/Polygon_soup.h"

#include <limits>
#include <optional>
#include <vector>

namespace segment_mesh {

/// For each of `Polygons::corners()` the next one around its point, that of the face across the
/// edge to the previous point of the face; `no_corner` where that edge is a border.
using Corner_links = std::vector<Polygons::Index>;

constexpr Polygons::Index no_corner = (std::numeric_limits<Polygons::Index>::max)();

/// The links, if the faces form an oriented 2-manifold: faces have at least three corners, none
/// twice; no two faces have an edge in the same direction; the faces at a point form one fan or one
/// disc.
///
/// There are some where \cgal's `is_polygon_soup_a_polygon_mesh()` says yes; that takes longer than
/// the reading of a file: it sorts all edges in a tree. O(C log d), where C is the number of
/// corners and d the largest number of faces at a point.
std::optional<Corner_links> link_corners(const Polygon_soup& soup);

inline bool is_oriented_manifold(const Polygon_soup& soup)
{
  return link_corners(soup).has_value();
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LINK_CORNERS_H
