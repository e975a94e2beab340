// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MERGE_POINTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MERGE_POINTS_H

#include <CGAL/Region_segmentation/internal/support/Function_ref.h>
#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// For each point that counts the lowest one equal to it, of those; -0 is 0. For each other one
/// itself.
inline std::vector<Surface::Index> lowest_of_equal_points(const Large_array<Double_3>& points,
                                                          Function_ref<bool(std::size_t)> counts)
{
  using Coordinates = std::array<double, 3>;
  std::unordered_map<Coordinates, Surface::Index, boost::hash<Coordinates>> lowest;
  std::vector<Surface::Index> result(points.size());
  for (Surface::Index v = 0; v < points.size(); ++v) {
    const Double_3& p = points[v];
    result[v] = counts(v)
                  ? lowest.emplace(Coordinates{p.x + 0.0, p.y + 0.0, p.z + 0.0}, v).first->second
                  : v;
  }
  return result;
}

/// Makes equal points one vertex, the lowest, as far as they are at sides whose neighbor is not
/// known.
inline void merge_points_of_open_sides(Raw_surface& raw)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  std::vector<bool> is_at_open_side(arrays.points.size());
  for (const auto& [face, side] : raw.open_sides)
    is_at_open_side[arrays.corners[side]] = is_at_open_side[arrays.corners[next_corner(
      arrays, face, side)]] = true;
  const std::vector<Index> lowest = lowest_of_equal_points(
    arrays.points, [&](std::size_t v) { return is_at_open_side[v]; });
  bool is_any_merged = false;
  for (Index v = 0; v < lowest.size(); ++v)
    is_any_merged = is_any_merged || lowest[v] != v;
  if (!is_any_merged)
    return;
  for (Index& v : arrays.corners)
    v = lowest[v];
  begin_at_lowest_vertices(raw, Execution());
  find_open_sides(raw);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MERGE_POINTS_H
