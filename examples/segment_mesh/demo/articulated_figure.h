// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ARTICULATED_FIGURE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ARTICULATED_FIGURE_H

#include "soup/Polygon_soup.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace segment_mesh {

inline constexpr const char* articulated_figure = "articulated_figure"; ///< its name

struct Articulated_figure
{
  Polygon_soup soup; ///< a closed oriented manifold of triangles
  std::vector<std::int64_t> part_of_face;
  std::size_t number_of_parts = 0;
};

/// A figure of ten parts: trunk, head, and two parts for each arm and leg. It stands: y is up.
Articulated_figure make_articulated_figure();

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ARTICULATED_FIGURE_H
