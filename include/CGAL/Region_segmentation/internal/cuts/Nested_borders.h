// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_NESTED_BORDERS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_NESTED_BORDERS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/internal/cuts/Border_cut.h>
#include <CGAL/Region_segmentation/internal/graph/Tree_regions.h>
#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/visitor.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Moves the borders of the segments of a merge tree to minimum cuts, from its roots down: merges are undone from the
/// last one on, and the border between the two parts of a segment moves within it. So partitions stay nested.
///
/// An element is its region's own until it moves to another part, or is cut off from the own elements of its part.
/// Then it is a guest: when its segment is divided, it joins the part that it borders on. A region can lose all its
/// elements.
///
/// O(P + R log R) in practice for P elements and R regions, and the cuts. `Distance`: see `Border_cut`
template <typename Distance>
class Nested_borders
{
public:
  using Index = Dual_graph::Index;

  /// `costs`: of the borders between adjacent elements; `areas`: of the elements; `region_of`: by element
  Nested_borders(const Dual_graph& costs, const Distance& distance, const std::vector<double>& areas,
                 const std::vector<Index>& region_of, const Merge_tree& tree)
    : m_costs(costs)
    , m_areas(areas)
    , m_region_of(region_of)
    , m_tree(tree)
    , m_tree_regions(tree)
    , m_segment_of(m_tree_regions.roots())
    , m_elements(tree.number_of_regions())
    , m_label_of(region_of.size())
    , m_is_own(region_of.size(), true)
    , m_is_waiting(region_of.size(), false)
    , m_guests(tree.number_of_regions())
    , m_area_of(tree.number_of_regions(), 0)
    , m_support(tree.merges().size(), 0)
    , m_cut(costs, distance, m_label_of)
  {
    collect_elements();
    count_support();
  }

  /// `number_of_cuts`: only the borders of so many last merges are moved.
  /// `width(area)`: of the band in which the border of two parts can move, by the area of the smaller part; 0: it stays.
  /// `is_fixed(region)`: whether its elements stay in the segments of the region; at most one region of a tree
  template <typename Width, typename IsFixed, typename ConcurrencyTag>
  void run(std::size_t number_of_cuts, const Width& width, const IsFixed& is_fixed,
           const Execution<ConcurrencyTag>& execution)
  {
    const std::size_t merges = m_tree.merges().size();
    Step_counter<ConcurrencyTag> undone(execution, merges);
    for (std::size_t i = merges; i-- > 0;) {
      std::vector<Index> guests = divide(i, is_fixed);
      if (merges - i <= number_of_cuts)
        move_border(i, guests, width, is_fixed);
      for (const Index guest : guests)
        m_guests[m_label_of[guest]].push_back(guest);
      undone.advance();
    }
  }

  /// By element: one of the regions.
  std::vector<Index> take_labels() { return std::move(m_label_of); }

private:
  static constexpr Index none = Tree_regions::none;

  void collect_elements()
  {
    for (const Index region : m_region_of)
      m_elements.count(region);
    m_elements.end_counting();
    for (std::size_t e = 0; e < m_region_of.size(); ++e) {
      m_elements.add(m_region_of[e], Index(e));
      m_label_of[e] = m_segment_of[m_region_of[e]];
      m_area_of[m_label_of[e]] += m_areas[e];
    }
  }

  // A segment is known to be connected as long as its regions are, and every merge in it is supported: by pairs of
  // adjacent own elements that it joins. Regions of which that no longer holds are suspect.

  void count_support()
  {
    for (std::size_t e = 0; e < m_region_of.size(); ++e)
      for_each_supported_merge(Index(e), [&](Index merge) { ++m_support[merge]; });
    for (std::size_t i = 0; i < m_support.size(); ++i) {
      m_support[i] /= 2; // each pair was counted twice
      if (m_support[i] == 0)
        m_suspects.push_back(m_tree.merges()[i].kept);
    }
  }

  template <typename F>
  void for_each_supported_merge(Index element, const F& f) const
  {
    for (const auto& step : m_costs.steps(element))
      if (m_is_own[step.face] && m_region_of[step.face] != m_region_of[element])
        if (const Index i = m_tree_regions.joining_merge(m_region_of[element], m_region_of[step.face]); i != none)
          f(i);
  }

  bool has_suspects(Index segment) const
  {
    return std::any_of(m_suspects.begin(), m_suspects.end(),
                       [&](Index region) { return m_segment_of[region] == segment; });
  }

  void make_guest(Index element)
  {
    m_is_own[element] = false;
    for_each_supported_merge(element, [&](Index merge) {
      if (--m_support[merge] == 0)
        m_suspects.push_back(m_region_of[element]);
    });
  }

  void suspect_if_disconnected(Index region)
  {
    std::vector<Index> own;
    for (const Index element : m_elements[region])
      if (m_is_own[element])
        own.push_back(element);
    set_waiting(own, true);
    if (own.empty() || component(own.front()).size() < own.size())
      m_suspects.push_back(region);
    set_waiting(own, false);
  }

  void set_waiting(const std::vector<Index>& elements, bool is_waiting)
  {
    for (const Index element : elements)
      m_is_waiting[element] = is_waiting;
  }

  /// Of the waiting elements.
  std::vector<Index> component(Index first)
  {
    std::vector<Index> result{first};
    m_is_waiting[first] = false;
    for (std::size_t i = 0; i < result.size(); ++i)
      for (const auto& step : m_costs.steps(result[i]))
        if (m_is_waiting[step.face]) {
          m_is_waiting[step.face] = false;
          result.push_back(step.face);
        }
    return result;
  }

  /// Undoes a merge: labels the elements of its segment by the two parts; returns the guests.
  template <typename IsFixed>
  std::vector<Index> divide(std::size_t i, const IsFixed& is_fixed)
  {
    const Index a = m_tree.merges()[i].kept, b = m_tree.merges()[i].removed;
    m_tree_regions.for_each_removed(i, [&](Index region) {
      m_segment_of[region] = b;
      for (const Index element : m_elements[region])
        if (m_is_own[element])
          m_label_of[element] = b;
    });
    std::vector<Index> guests = std::exchange(m_guests[a], {});
    for (const Index part : {a, b})
      if (has_suspects(part))
        keep_largest_component(own_elements(i, part), guests, is_fixed);
    for (const Index guest : guests)
      m_label_of[guest] = none;
    join_parts(guests, a, b);
    return guests;
  }

  /// Of a part of a merge.
  std::vector<Index> own_elements(std::size_t i, Index part) const
  {
    std::vector<Index> result;
    const auto add = [&](Index region) {
      for (const Index element : m_elements[region])
        if (m_is_own[element])
          result.push_back(element);
    };
    if (part == m_tree.merges()[i].kept)
      m_tree_regions.for_each_kept(i, add);
    else
      m_tree_regions.for_each_removed(i, add);
    return result;
  }

  /// That with fixed elements, else the largest by area; of equal ones that of the lowest element. The others become
  /// guests.
  template <typename IsFixed>
  void keep_largest_component(std::vector<Index> elements, std::vector<Index>& guests, const IsFixed& is_fixed)
  {
    std::sort(elements.begin(), elements.end());
    std::vector<Index> largest;
    double largest_area = -1;
    set_waiting(elements, true);
    for (const Index first : elements) {
      if (!m_is_waiting[first])
        continue;
      std::vector<Index> next = component(first);
      double area = 0;
      for (const Index element : next)
        area += is_fixed(m_region_of[element]) ? std::numeric_limits<double>::infinity() : m_areas[element];
      if (area > largest_area) {
        std::swap(largest, next);
        largest_area = area;
      }
      for (const Index element : next) {
        make_guest(element);
        guests.push_back(element);
      }
    }
  }

  /// In rounds: elements without a label that border on one of the parts join the one with the dearer border, of equal
  /// ones the first.
  void join_parts(std::vector<Index> unlabeled, Index a, Index b)
  {
    std::vector<std::pair<Index, Index>> joined; // element, part
    for (std::vector<Index> rest; !unlabeled.empty(); std::swap(unlabeled, rest)) {
      joined.clear();
      rest.clear();
      for (const Index element : unlabeled) {
        const double to_a = border_cost(element, a), to_b = border_cost(element, b);
        if (to_a >= 0 || to_b >= 0)
          joined.push_back({element, to_a >= to_b ? a : b});
        else
          rest.push_back(element);
      }
      if (joined.empty()) { // no part has own elements
        joined.push_back({rest.back(), a});
        rest.pop_back();
      }
      for (const auto& [element, part] : joined)
        m_label_of[element] = part;
    }
  }

  /// Below 0 if the element is not adjacent to the part.
  double border_cost(Index element, Index part) const
  {
    double cost = 0;
    bool is_adjacent = false;
    for (const auto& step : m_costs.steps(element))
      if (m_label_of[step.face] == part) {
        cost += double(step.length);
        is_adjacent = true;
      }
    return is_adjacent ? cost : -1;
  }

  template <typename Width, typename IsFixed>
  void move_border(std::size_t i, std::vector<Index>& guests, const Width& width, const IsFixed& is_fixed)
  {
    const Index a = m_tree.merges()[i].kept, b = m_tree.merges()[i].removed;
    std::vector<Index> elements_of_b = own_elements(i, b), border;
    for (const Index guest : guests)
      if (m_label_of[guest] == b)
        elements_of_b.push_back(guest);
    for (const Index element : elements_of_b) {
      m_area_of[b] += m_areas[element];
      for (const auto& step : m_costs.steps(element))
        if (m_label_of[step.face] == a)
          border.insert(border.end(), {element, step.face});
    }
    m_area_of[a] -= m_area_of[b];
    const double band_width = width((std::min)(m_area_of[a], m_area_of[b]));
    if (!(band_width > 0))
      return;
    const std::vector<Index> moved = m_cut.move_border(
      a, b, border, band_width, [&](Index element) { return is_fixed(m_region_of[element]); });
    std::vector<Index> touched;
    for (const Index element : moved) {
      const Index now = m_label_of[element];
      m_area_of[now] += m_areas[element];
      m_area_of[now == a ? b : a] -= m_areas[element];
      if (m_is_own[element]) {
        make_guest(element);
        guests.push_back(element);
        touched.push_back(m_region_of[element]);
      }
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const Index region : touched)
      suspect_if_disconnected(region);
  }

  const Dual_graph& m_costs;
  const std::vector<double>& m_areas;
  const std::vector<Index>& m_region_of;
  const Merge_tree& m_tree;
  const Tree_regions m_tree_regions;
  std::vector<Index> m_segment_of;  // of the regions, by the tree; named by its lowest region
  Grouped_items<Index> m_elements;  // by region
  std::vector<Index> m_label_of;    // by element: its segment
  std::vector<char> m_is_own;       // by element
  std::vector<char> m_is_waiting;   // by element: for a component
  std::vector<std::vector<Index>> m_guests; // by segment
  std::vector<double> m_area_of;    // by segment, as long as borders are moved
  std::vector<Index> m_support;     // by merge: pairs of adjacent own elements
  std::vector<Index> m_suspects;    // regions
  Border_cut<Distance> m_cut;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_NESTED_BORDERS_H
