// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_NESTING_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_NESTING_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/Axis_box.h>
#include <CGAL/Region_segmentation/internal/surface/Face_tree.h>
#include <CGAL/Region_segmentation/internal/surface/distances.h>

#include <array>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

inline bool is_lower(const Double_3& p, const Double_3& q)
{
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

/// Whether a triangle is above a point. Comparisons are half-open and computed alike from both
/// sides of an edge, so an upward ray passes through exactly one of the faces around an edge or a
/// vertex.
inline bool is_above_point(const Triangle& t, const Double_3& at)
{
  // Whether a side passes the point in the plane on the side of larger y.
  const auto passes = [&](Double_3 p, Double_3 q) {
    if ((p.x <= at.x) == (q.x <= at.x))
      return false;
    if (is_lower(q, p))
      std::swap(p, q);
    return p.y + (at.x - p.x) / (q.x - p.x) * (q.y - p.y) > at.y;
  };
  if (passes(t[0], t[1]) == (passes(t[1], t[2]) != passes(t[2], t[0])))
    return false;
  const Double_3 n = cross(t[1] - t[0], t[2] - t[0]), d = at - t[0];
  return n.z != 0 && t[0].z - (n.x * d.x + n.y * d.y) / n.z > at.z;
}

/// For each component the closed one with the largest box, of several the lowest, in which it lies;
/// itself if there is none or if it is open. A component lies in another one if its box does and an
/// odd number of faces of the other one are above its lowest vertex; so of two that cross either,
/// neither or one may lie in the other. O(F log F) in practice.
inline std::vector<Surface::Index> find_outermost(const Surface& surface,
                                                  const Partition& component_of,
                                                  const std::vector<bool>& is_closed)
{
  using Index = Surface::Index;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Axis_box> boxes(is_closed.size());
  std::vector<Double_3> lowest(is_closed.size(), {infinity, infinity, infinity});
  const Face_tree tree(surface);
  const auto component = [&](Index leaf) { return component_of[tree.face(leaf)]; };
  for (Index node = 0; node < tree.boxes().number_of_nodes(); ++node)
    if (tree.boxes().is_leaf(node)) {
      boxes[component(node)].add(tree.boxes().box(node));
      for (const Double_3& p : tree.triangle(node))
        if (is_lower(p, lowest[component(node)]))
          lowest[component(node)] = p;
    }

  const auto size = [&](Index c) {
    return boxes[c].extent(0) + boxes[c].extent(1) + boxes[c].extent(2);
  };
  const auto is_in_box_of = [&](Index c, Index d) {
    Axis_box both = boxes[d];
    both.add(boxes[c]);
    return both.low == boxes[d].low && both.high == boxes[d].high && size(c) < size(d);
  };
  std::vector<Index> result;
  for (Index c = 0; c < is_closed.size(); ++c) {
    result.push_back(c);
    if (!is_closed[c])
      continue;
    Axis_box above = box_of(std::array{lowest[c]});
    above.high[2] = std::numeric_limits<float>::infinity();
    std::map<Index, bool> contains; // by component: the parity of its faces above
    tree.boxes().search([&](Index node) { return squared_gap(tree.boxes().box(node), above); },
                        (std::numeric_limits<double>::min)(),
                        [&](Index leaf) {
                          const Index d = component(leaf);
                          if (is_closed[d] && is_in_box_of(c, d))
                            contains[d] ^= is_above_point(tree.triangle(leaf), lowest[c]);
                        });
    for (const auto& [d, is_inside] : contains)
      if (is_inside && (result[c] == c || size(d) > size(result[c])))
        result[c] = d;
  }
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_NESTING_H
