// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MARK_CONSTRAINTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MARK_CONSTRAINTS_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/collect_adjacencies.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Two vertices.
using Vertex_pair = std::pair<Surface::Index, Surface::Index>;

/// The coordinates of two points, the lower one first.
using Point_pair = std::array<std::array<double, 3>, 2>;

inline Point_pair point_pair(const Double_3& p, const Double_3& q)
{
  const std::array<double, 3> a{p.x, p.y, p.z}, b{q.x, q.y, q.z};
  return a < b ? Point_pair{a, b} : Point_pair{b, a};
}

/// Constrains the edges and seams between pairs of vertices. A vertex that no face uses, since its
/// point is that of another one, stands for all vertices with this point. O(F log C) for C pairs.
inline void mark_constraints(Surface& surface, const std::vector<Vertex_pair>& pairs)
{
  using Index = Surface::Index;
  if (pairs.empty())
    return;
  Surface_arrays& arrays = arrays_of(surface);
  std::vector<bool> is_used(surface.number_of_vertices());
  for (const Index v : arrays.corners)
    is_used[v] = true;
  std::vector<std::pair<Point_pair, Vertex_pair>> constrained;
  for (const Vertex_pair& pair : pairs)
    constrained.push_back(
      {point_pair(surface.point(pair.first), surface.point(pair.second)), pair});
  std::sort(constrained.begin(), constrained.end());
  const auto is_constrained = [&](Index v, Index w) {
    const auto is = [&](Index end, Index vertex) { return end == vertex || !is_used[end]; };
    const Point_pair points = point_pair(surface.point(v), surface.point(w));
    auto c = std::lower_bound(constrained.begin(), constrained.end(),
                              std::make_pair(points, Vertex_pair(0, 0)));
    for (; c != constrained.end() && c->first == points; ++c)
      if (const auto& [p, q] = c->second; (is(p, v) && is(q, w)) || (is(p, w) && is(q, v)))
        return true;
    return false;
  };
  for (Index f = 0; f < surface.number_of_faces(); ++f) {
    Index side = arrays.first_corners[f];
    for_each_side(surface, f, [&](Index v, Index w) {
      if (const Index a = arrays.adjacencies[side++]; a != Surface::none && is_constrained(v, w))
        arrays.flags[a] |= Surface::CONSTRAINED;
    });
  }
  join_degenerate_faces(surface);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MARK_CONSTRAINTS_H
