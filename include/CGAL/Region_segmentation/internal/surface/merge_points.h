// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MERGE_POINTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MERGE_POINTS_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/internal/support/Function_ref.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/for_each_repetition.h>
#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>
#include <CGAL/Region_segmentation/internal/surface/match_sides.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// For each point that counts the lowest one equal to it, of those; -0 is 0. For each other one
/// itself. Empty if all are different.
inline std::vector<Surface::Index> lowest_of_equal_points(const Large_array<Double_3>& points,
                                                          Function_ref<bool(std::size_t)> counts)
{
  using Index = Surface::Index;
  const auto coordinates = [&](Index v) {
    return std::array{points[v].x + 0.0, points[v].y + 0.0, points[v].z + 0.0};
  };
  std::vector<Index> lowest;
  for_each_repetition(
    points.size(),
    [&](const auto& add) {
      for (Index v = 0; v < points.size(); ++v)
        if (counts(v))
          add(v, boost::hash<std::array<double, 3>>()(coordinates(v)));
    },
    [&](Index v, Index w) { return coordinates(v) == coordinates(w); },
    [&](Index v, Index first) {
      if (lowest.empty()) {
        lowest.resize(points.size());
        std::iota(lowest.begin(), lowest.end(), Index(0));
      }
      lowest[v] = first;
    });
  return lowest;
}

/// Makes equal points one vertex, the lowest, as far as they are at open sides that do not make an
/// edge of two faces: so closed components keep their vertices, of a face graph and of polygons.
inline void merge_points_of_open_sides(Raw_surface& raw)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  std::vector<bool> is_at_open_side(arrays.points.size());
  for_each_open_edge(raw, [&](const std::vector<Side_of_edge>& sides) {
    if (sides.size() != 2)
      is_at_open_side[sides[0].lower_vertex] = is_at_open_side[sides[0].higher_vertex] = true;
  });
  const std::vector<Index> lowest = lowest_of_equal_points(
    arrays.points, [&](std::size_t v) { return is_at_open_side[v]; });
  if (lowest.empty())
    return;
  for (Index& v : arrays.corners)
    v = lowest[v];
  begin_at_lowest_vertices(raw, Execution());
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MERGE_POINTS_H
