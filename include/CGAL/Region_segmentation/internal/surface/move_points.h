// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MOVE_POINTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MOVE_POINTS_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/surface/compute_normals.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Moves the points of a surface, and with them normals, areas and the signs of angles. Degenerate
/// faces and the lengths of adjacencies remain as they are.
inline void move_points(Surface& surface, Large_array<Double_3> points, const Execution& execution)
{
  Surface_arrays& arrays = arrays_of(surface);
  arrays.points = std::move(points);
  std::vector<std::pair<std::size_t, double>> degenerate; // faces and their areas
  for (std::size_t f = 0; f < arrays.areas.size(); ++f)
    if (surface.is_degenerate(f))
      degenerate.push_back({f, arrays.areas[f]});
  compute_normals(surface, execution);
  for (const auto& [face, area] : degenerate) {
    arrays.normals[face] = {0, 0, 0};
    arrays.areas[face] = area;
  }
  sum_up(surface);
  for_each_index(execution, arrays.flags.size(), [&](std::size_t a) {
    if (!surface.has_angle(a))
      return;
    const Surface::Index lower = surface.lower_face(a), higher = surface.higher_face(a);
    const auto [direction, number] = common_edges(surface, lower, higher);
    if (number > 0)
      arrays.flags[a] = with_sign(
        arrays.flags[a], sign_of_edge(surface.normal(higher), surface.normal(lower), direction));
  });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MOVE_POINTS_H
