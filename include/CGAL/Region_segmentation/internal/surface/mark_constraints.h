// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MARK_CONSTRAINTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MARK_CONSTRAINTS_H

#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/merge_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Two vertices.
using Vertex_pair = std::pair<Surface::Index, Surface::Index>;

/// Constrains the adjacencies across edges, and the seams, between the given pairs of vertices;
/// equal points count as one. O(F log F + C log C) for C pairs.
inline void mark_constraints(const Surface& surface, std::vector<Vertex_pair> pairs,
                             Constraints& constraints)
{
  using Index = Surface::Index;
  if (pairs.empty())
    return;
  const std::vector<Index> merged = lowest_of_equal_points(arrays_of(surface).points,
                                                           [](std::size_t) { return true; });
  const auto lowest = [&](Index v) { return merged.empty() ? v : merged[v]; };
  const auto edge = [&](Index v, Index w) {
    return Vertex_pair(std::minmax(lowest(v), lowest(w)));
  };
  for (Vertex_pair& pair : pairs)
    pair = edge(pair.first, pair.second);
  std::sort(pairs.begin(), pairs.end());

  std::vector<std::pair<Vertex_pair, Index>> sides; // with their faces
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    for_each_side(surface, f, [&](Index v, Index w) {
      if (std::binary_search(pairs.begin(), pairs.end(), edge(v, w)))
        sides.push_back({edge(v, w), f});
    });
  std::sort(sides.begin(), sides.end());
  const auto has_side = [&](const Vertex_pair& side, Index face) {
    return std::binary_search(sides.begin(), sides.end(), std::make_pair(side, face));
  };
  for (const auto& [side, face] : sides) {
    const double length = norm(surface.point(side.first) - surface.point(side.second));
    for (std::size_t a = surface.first_adjacency(face);
         a < surface.number_of_adjacencies() && surface.higher_face(a) == face; ++a) {
      const double share = surface.length(a) / (length > 0 ? length : 1);
      const bool is_of_side = std::abs(share - 1) < 1e-9 || std::abs(share - 0.5) < 1e-9;
      if (!surface.has_flag(a, Surface::LINK) && is_of_side &&
          has_side(side, surface.lower_face(a)))
        constraints.add(a, surface.number_of_adjacencies());
    }
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MARK_CONSTRAINTS_H
