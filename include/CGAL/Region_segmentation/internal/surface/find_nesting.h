// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_NESTING_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_NESTING_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/Axis_box.h>
#include <CGAL/Region_segmentation/internal/surface/distances.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
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
/// through exactly one of the faces around an edge or a vertex. A face is compared with the
/// vertices in its range of x or y: O(F log C) and these comparisons, a few for faces of even size.
class Nesting_finder
{
public:
  using Index = Surface::Index;

  Nesting_finder(const Surface& surface, const Partition& component_of_face,
                 const std::vector<bool>& is_closed)
    : m_surface(surface)
    , m_component_of(component_of_face)
    , m_is_closed(is_closed)
    , m_boxes(is_closed.size())
    , m_queries(number_of_orders * is_closed.size())
  {
    find_boxes_and_queries();
    for_each_triangle([&](Index component, const Triangle& t) { find_crossings(component, t); });
  }

  /// For each component the outermost closed one that contains it, itself if there is none.
  std::vector<Index> outermost()
  {
    std::vector<Index> result(m_boxes.size()), largest_first(m_boxes.size());
    std::iota(result.begin(), result.end(), Index(0));
    const std::vector<std::pair<Index, Index>> pairs = containments();
    const auto size = [&](Index c) {
      return m_boxes[c].extent(0) + m_boxes[c].extent(1) + m_boxes[c].extent(2);
    };
    std::iota(largest_first.begin(), largest_first.end(), Index(0));
    std::stable_sort(largest_first.begin(), largest_first.end(),
                     [&](Index c, Index d) { return size(c) > size(d); });
    for (Index c : largest_first) {
      // A container has the larger box, so its result is known.
      const auto first = std::lower_bound(pairs.begin(), pairs.end(), std::make_pair(c, Index(0)));
      Index largest = c;
      for (auto p = first; p != pairs.end() && p->first == c; ++p)
        if (largest == c || size(p->second) > size(largest))
          largest = p->second;
      result[c] = largest == c ? c : result[largest];
    }
    return result;
  }

private:
  static constexpr std::size_t number_of_orders = 3;

  /// Passes the triangles of closed components.
  template <typename F>
  void for_each_triangle(const F& f) const
  {
    for (std::size_t face = 0; face < m_component_of.size(); ++face)
      if (m_is_closed[m_component_of[face]]) {
        const auto point = [&](std::size_t i) {
          return m_surface.point(m_surface.corner(face, i));
        };
        for (std::size_t i = 2; i < m_surface.number_of_corners(face); ++i)
          f(m_component_of[face], Triangle{point(0), point(i - 1), point(i)});
      }
  }

  static std::array<double, 3> in_order(const Double_3& p, std::size_t order)
  {
    return order == 0   ? std::array<double, 3>{p.x, p.y, p.z}
           : order == 1 ? std::array<double, 3>{p.y, p.z, p.x}
                        : std::array<double, 3>{p.z, p.x, p.y};
  }

  void find_boxes_and_queries()
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::fill(m_queries.begin(), m_queries.end(), Double_3{infinity, infinity, infinity});
    for_each_triangle([&](Index component, const Triangle& t) {
      for (const Double_3& p : t) {
        m_boxes[component].add(p);
        for (std::size_t order = 0; order < number_of_orders; ++order) {
          Double_3& lowest = m_queries[number_of_orders * component + order];
          if (in_order(p, order) < in_order(lowest, order))
            lowest = p;
        }
      }
    });
    Axis_box all;
    for (const Axis_box& box : m_boxes)
      all.add(box);
    m_axis = all.extent(1) > all.extent(0) ? 1 : 0;
    for (std::size_t q = 0; q < m_queries.size(); ++q)
      m_in_order.emplace_back(in_order(m_queries[q], m_axis)[0], Index(q));
    std::sort(m_in_order.begin(), m_in_order.end());
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

  void find_crossings(Index component, const Triangle& t)
  {
    const Axis_box box = box_of(t);
    auto place = std::lower_bound(m_in_order.begin(), m_in_order.end(),
                                  std::make_pair(box.low[m_axis], Index(0)));
    for (; place != m_in_order.end() && place->first <= box.high[m_axis]; ++place)
      if (const Index q = place->second;
          is_smaller(q / number_of_orders, component) && is_above_point(t, m_queries[q]))
        m_crossings.emplace_back(q, component);
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

  /// Pairs of a component and one that contains it, sorted.
  std::vector<std::pair<Index, Index>> containments()
  {
    std::vector<std::pair<Index, Index>> votes, result;
    for_each_repeated(m_crossings, [&](const auto& crossing, std::size_t number) {
      if (number % 2 == 1)
        votes.emplace_back(crossing.first / Index(number_of_orders), crossing.second);
    });
    for_each_repeated(votes, [&](const auto& vote, std::size_t number) {
      if (number * 2 > number_of_orders)
        result.push_back(vote);
    });
    return result;
  }

  /// Sorts pairs, and calls `f(pair, number)` for different ones, with how often each is there.
  template <typename F>
  static void for_each_repeated(std::vector<std::pair<Index, Index>>& pairs, const F& f)
  {
    std::sort(pairs.begin(), pairs.end());
    for (auto first = pairs.begin(); first != pairs.end();) {
      const auto past = std::upper_bound(first, pairs.end(), *first);
      f(*first, std::size_t(past - first));
      first = past;
    }
  }

  const Surface& m_surface;
  const Partition& m_component_of;
  const std::vector<bool>& m_is_closed;
  std::vector<Axis_box> m_boxes;   // by component
  std::vector<Double_3> m_queries; // three for each component; infinite for open ones
  std::size_t m_axis = 0;          // x or y, along which the queries are spread more
  std::vector<std::pair<double, Index>> m_in_order; // queries along it
  std::vector<std::pair<Index, Index>> m_crossings; // a query and a component with a face above it
};

/// For each component the outermost closed one that contains it, itself if there is none or if it
/// is open. Of two components that cross either, neither or one may be in the other. O(F + C log C)
/// for faces of even size.
inline std::vector<Surface::Index> outermost_of(const Surface& surface,
                                                const Partition& component_of_face,
                                                const std::vector<bool>& is_closed)
{
  if (std::count(is_closed.begin(), is_closed.end(), true) < 2) {
    std::vector<Surface::Index> result(is_closed.size());
    std::iota(result.begin(), result.end(), Surface::Index(0));
    return result;
  }
  return Nesting_finder(surface, component_of_face, is_closed).outermost();
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_NESTING_H
