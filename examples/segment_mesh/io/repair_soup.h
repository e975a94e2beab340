// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_REPAIR_SOUP_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_REPAIR_SOUP_H

#include "soup/Polygon_soup.h"

#include <cstddef>

namespace segment_mesh {

/// What a repair did.
struct Repair
{
  std::size_t turned_faces;
  std::size_t merged_points; ///< points of faces that went into another one at the same place
  std::size_t split_points; ///< points that were added where the surface was not a manifold
};

/// Makes an oriented 2-manifold of a soup, by \cgal's polygon soup functions. Points that are left
/// have the coordinates that they had; there may be no face left.
Repair repair_soup(Polygon_soup& soup);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_REPAIR_SOUP_H
