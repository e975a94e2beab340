// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_NESTING_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_NESTING_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Function_ref.h>
#include <CGAL/Region_segmentation/internal/surface/Axis_box.h>
#include <CGAL/Region_segmentation/internal/surface/Component_tree.h>
#include <CGAL/Region_segmentation/internal/surface/distances.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds which closed components lie in which: the parity of the faces above a vertex. Three
/// vertices of each component vote, the extreme ones in three orders, in case that one touches
/// another component.
///
/// Comparisons are half-open and computed alike from both sides of an edge, so an upward ray passes
/// through exactly one of the faces around an edge or a vertex.
class Nesting_finder
{
public:
  using Index = Surface::Index;

  Nesting_finder(const Surface& surface, const Partition& component_of_face,
                 const std::vector<bool>& is_closed)
    : m_is_closed(is_closed)
    , m_tree(surface, component_of_face)
    , m_boxes(is_closed.size())
    , m_extreme_points(is_closed.size(),
                       Extreme_points{all(infinity), all(infinity), all(infinity)})
  {
    for (std::size_t f = 0; f < component_of_face.size(); ++f)
      if (is_closed[component_of_face[f]])
        for (std::size_t i = 0; i < surface.number_of_corners(f); ++i)
          add_point(component_of_face[f], surface.point(surface.corner(f, i)));
  }

  /// For each component the outermost closed one that contains it, itself if there is none or if it
  /// is open. Of two components that cross either, neither or one may be in the other. O(F log F)
  /// in practice.
  std::vector<Index> outermost()
  {
    std::vector<Index> container;
    for (Index c = 0; c < m_boxes.size(); ++c)
      container.push_back(m_is_closed[c] ? largest_container(c) : c);
    std::vector<Index> result;
    for (Index c : container) {
      while (container[c] != c) // ends: the box of a container is larger
        c = container[c];
      result.push_back(c);
    }
    return result;
  }

private:
  static constexpr std::size_t number_of_orders = 3;
  using Extreme_points = std::array<Double_3, number_of_orders>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr Double_3 all(double x) { return {x, x, x}; }

  static std::array<double, 3> in_order(const Double_3& p, std::size_t order)
  {
    return order == 0   ? std::array<double, 3>{p.x, p.y, p.z}
           : order == 1 ? std::array<double, 3>{p.y, p.z, p.x}
                        : std::array<double, 3>{p.z, p.x, p.y};
  }

  void add_point(Index component, const Double_3& p)
  {
    m_boxes[component].add_point({p.x, p.y, p.z});
    for (std::size_t order = 0; order < number_of_orders; ++order) {
      Double_3& lowest = m_extreme_points[component][order];
      if (in_order(p, order) < in_order(lowest, order))
        lowest = p;
    }
  }

  /// Whether the box of `inner` is in that of `outer` and not the same.
  bool is_smaller(Index inner, Index outer) const
  {
    const Axis_box &a = m_boxes[inner], &b = m_boxes[outer];
    bool is_inside = a.low != b.low || a.high != b.high;
    for (std::size_t i = 0; i < 3; ++i)
      is_inside = is_inside && a.low[i] >= b.low[i] && a.high[i] <= b.high[i];
    return is_inside;
  }

  /// Of those with the largest box the lowest, itself if there is none.
  Index largest_container(Index component)
  {
    std::map<Index, std::array<bool, number_of_orders>> contains; // by component: the points
    for (std::size_t order = 0; order < number_of_orders; ++order)
      for_each_crossing(component, m_extreme_points[component][order], Component_tree::root(),
                        [&](Index c) { contains[c][order] = !contains[c][order]; });
    const auto size = [&](Index c) {
      return m_boxes[c].extent(0) + m_boxes[c].extent(1) + m_boxes[c].extent(2);
    };
    Index result = component;
    for (const auto& [c, points] : contains)
      if (std::count(points.begin(), points.end(), true) * 2 > std::ptrdiff_t(number_of_orders) &&
          (result == component || size(c) > size(result)))
        result = c;
    return result;
  }

  /// Calls `f(component)` for the triangles of a node above a point, in components in which that of
  /// the point may be.
  void for_each_crossing(Index inner, const Double_3& at, Index node, Function_ref<void(Index)> f)
  {
    const Axis_box& box = m_tree[node].box;
    const Index component = m_tree[node].component;
    if (!(at.x >= box.low[0] && at.x <= box.high[0] && at.y >= box.low[1] && at.y <= box.high[1]))
      return;
    if (component != Component_tree::none &&
        !(m_is_closed[component] && is_smaller(inner, component)))
      return;
    if (m_tree.is_leaf(node)) {
      for (Index i = m_tree[node].begin; i < m_tree[node].end; ++i)
        if (is_above_point(m_tree.triangle(m_tree.part(i)), at))
          f(component);
      return;
    }
    const Index child = m_tree.children(node);
    for_each_crossing(inner, at, child, f);
    for_each_crossing(inner, at, child + 1, f);
  }

  /// Whether the segment p, q in the plane passes the point on the side of larger y.
  static bool passes(Double_3 p, Double_3 q, const Double_3& at)
  {
    if ((p.x <= at.x) == (q.x <= at.x))
      return false;
    if (std::tie(q.x, q.y, q.z) < std::tie(p.x, p.y, p.z))
      std::swap(p, q);
    return p.y + (at.x - p.x) / (q.x - p.x) * (q.y - p.y) > at.y;
  }

  static bool is_above_point(const Triangle& t, const Double_3& at)
  {
    if (passes(t[0], t[1], at) == (passes(t[1], t[2], at) != passes(t[2], t[0], at)))
      return false;
    const Double_3 n = cross(t[1] - t[0], t[2] - t[0]), d = at - t[0];
    return n.z != 0 && t[0].z - (n.x * d.x + n.y * d.y) / n.z > at.z;
  }

  const std::vector<bool>& m_is_closed;
  Component_tree m_tree;
  std::vector<Axis_box> m_boxes;                // by component
  std::vector<Extreme_points> m_extreme_points; // by component; infinite for open ones
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_NESTING_H
