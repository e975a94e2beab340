// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_NESTED_BORDERS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_NESTED_BORDERS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/internal/superfacets/Border_cut.h>
#include <CGAL/Region_segmentation/internal/superfacets/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>
#include <CGAL/Region_segmentation/internal/support/components.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The elements of the regions of a merge tree while regions lose some.
///
/// Regions have places in the order of the tree: those of the part that a merge keeps, then those
/// of the part that it removes. So each part is a range of places.
class Tree_elements
{
public:
  using Index = Dual_graph::Index;

  struct Part
  {
    std::size_t begin, end; ///< places of regions
  };

  /// `region_of`: by element
  Tree_elements(const Dual_graph& adjacency, const std::vector<Index>& region_of,
                const Merge_tree& tree)
    : m_adjacency(adjacency)
    , m_region_of(region_of)
    , m_tree(tree)
    , m_place_of(tree.number_of_regions())
    , m_lost(tree.number_of_regions())
    , m_is_there(region_of.size(), true)
    , m_is_waiting(region_of.size(), false)
  {
    set_places();
    m_elements = Grouped_items<Index>(m_place_of.size(), [&](const auto& add) {
      for (std::size_t e = 0; e < region_of.size(); ++e)
        add(m_place_of[region_of[e]], Index(e));
    });
  }

  /// The parts of the segment that a merge makes.
  Part kept(std::size_t merge) const
  {
    const Merge_tree::Merge& m = m_tree.merges()[merge];
    return {m_place_of[m.kept], m_place_of[m.removed]};
  }
  Part removed(std::size_t merge) const
  {
    const std::size_t begin = m_place_of[m_tree.merges()[merge].removed];
    return {begin, begin + m_sizes_of_removed[merge]};
  }

  /// Whether the region of an element still has it.
  bool has(Index element) const { return m_is_there[element]; }

  /// Whether a part has any left.
  bool has_elements(const Part& part) const
  {
    for (std::size_t i = part.begin; i < part.end; ++i)
      if (m_lost[i].size() < m_elements[i].size())
        return true;
    return false;
  }

  /// Calls `f(element)` for the elements that a part still has, in order by region.
  template <typename F>
  void for_each(const Part& part, const F& f) const
  {
    for (std::size_t i = part.begin; i < part.end; ++i)
      for (const Index element : m_elements[i])
        if (has(element))
          f(element);
  }

  /// Those that a part has lost.
  std::vector<Index> lost(const Part& part) const
  {
    std::vector<Index> result;
    for (std::size_t i = part.begin; i < part.end; ++i)
      result.insert(result.end(), m_lost[i].begin(), m_lost[i].end());
    return result;
  }

  /// Takes elements from their regions.
  void remove(const std::vector<Index>& elements)
  {
    for (const Index element : elements) {
      m_is_there[element] = false;
      m_lost[m_place_of[m_region_of[element]]].push_back(element);
    }
  }

  /// The connected components of the elements that a part has, each in order.
  std::vector<std::vector<Index>> components(const Part& part)
  {
    std::vector<std::vector<Index>> result;
    for_each(part, [&](Index element) { m_is_waiting[element] = true; });
    for_each(part, [&](Index element) {
      if (m_is_waiting[element])
        result.push_back(waiting_component(element));
    });
    return result;
  }

private:
  void set_places()
  {
    std::vector<Index> sizes(m_place_of.size(), 1); // of segments, by their lowest region
    std::vector<bool> is_removed(m_place_of.size());
    for (const Merge_tree::Merge& merge : m_tree.merges()) {
      m_sizes_of_removed.push_back(sizes[merge.removed]);
      sizes[merge.kept] += sizes[merge.removed];
      is_removed[merge.removed] = true;
    }
    Index place = 0;
    for (std::size_t r = 0; r < m_place_of.size(); ++r)
      if (!is_removed[r]) {
        m_place_of[r] = place;
        place += sizes[r];
      }
    for (std::size_t i = m_tree.merges().size(); i-- > 0;) {
      const Merge_tree::Merge& merge = m_tree.merges()[i];
      sizes[merge.kept] -= m_sizes_of_removed[i];
      m_place_of[merge.removed] = m_place_of[merge.kept] + sizes[merge.kept];
    }
  }

  /// Of those that wait; they do not wait any more then.
  std::vector<Index> waiting_component(Index first)
  {
    std::vector<Index> result{first};
    m_is_waiting[first] = false;
    for (std::size_t i = 0; i < result.size(); ++i)
      for (const auto& step : m_adjacency.steps(result[i]))
        if (m_is_waiting[step.face]) {
          m_is_waiting[step.face] = false;
          result.push_back(step.face);
        }
    std::sort(result.begin(), result.end());
    return result;
  }

  const Dual_graph& m_adjacency;
  const std::vector<Index>& m_region_of;
  const Merge_tree& m_tree;
  std::vector<Index> m_place_of;              // by region
  std::vector<Index> m_sizes_of_removed;      // by merge: the number of regions
  Grouped_items<Index> m_elements;            // by place, those that were lost included
  std::vector<std::vector<Index>> m_lost;     // by place
  std::vector<char> m_is_there, m_is_waiting; // by element; to be reached by a search
};

/// Moves the borders of the segments of a merge tree to minimum cuts, from its roots down: merges
/// are undone from the last one on, and the border between the two parts of a segment moves within
/// it. So partitions stay nested.
///
/// An element is its region's own until it moves to another part, or is cut off from the own
/// elements of its part. Then it is a guest: when its segment is divided, it joins the part that it
/// borders on. A region can lose all its elements.
///
/// O(P log R + R h) in practice for P elements and R regions in a tree of height h, and the cuts.
class Nested_borders
{
public:
  using Index = Dual_graph::Index;

  /// `costs`: of the borders between adjacent elements; `areas`: of the elements; `region_of`: by
  /// element
  Nested_borders(const Dual_graph& costs, std::function<double(Index, Index)> distance,
                 const std::vector<double>& areas, const std::vector<Index>& region_of,
                 const Merge_tree& tree)
    : m_costs(costs)
    , m_areas(areas)
    , m_region_of(region_of)
    , m_tree(tree)
    , m_elements(costs, region_of, tree)
    , m_label_of(region_of.size())
    , m_guests(tree.number_of_regions())
    , m_area_of(tree.number_of_regions(), 0)
    , m_cut(costs, distance, m_label_of)
  {
    Lowest_root_forest segments(tree.number_of_regions());
    for (const Merge_tree::Merge& merge : tree.merges())
      segments.unite(merge.kept, merge.removed);
    for (std::size_t e = 0; e < region_of.size(); ++e) {
      m_label_of[e] = segments.root(region_of[e]);
      m_area_of[m_label_of[e]] += areas[e];
    }
  }

  /// `number_of_cuts`: only the borders of so many last merges are moved; `number_of_segments`:
  /// ends when there are so many, empty ones not counted. `width(area)`: of the band in which the
  /// border of two parts can move, by the area of the smaller part; 0: it stays.
  /// `is_fixed(region)`: whether its elements stay in the segments of the region; at most one
  /// region of a tree
  void run(std::size_t number_of_cuts, std::size_t number_of_segments,
           std::function<double(double)> width, std::function<bool(Index)> is_fixed,
           const Execution& execution)
  {
    const std::size_t merges = m_tree.merges().size();
    std::size_t segments = m_tree.number_of_regions() - merges;
    Step_counter undone(execution, (std::min)(merges, number_of_segments));
    for (std::size_t i = merges; i-- > 0 && segments < number_of_segments;) {
      std::vector<Index> guests = divide(i, is_fixed);
      segments += std::size_t(have_both_elements(i, guests));
      if (merges - i <= number_of_cuts)
        move_border(i, guests, width, is_fixed);
      for (const Index guest : guests)
        m_guests[m_label_of[guest]].push_back(guest);
      undone.advance();
    }
  }

  /// By element: the lowest region of its segment; its region, if `run()` did not end before.
  std::vector<Index> take_labels() { return std::move(m_label_of); }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  /// Undoes a merge: labels the elements of its segment by the two parts; returns the guests.
  std::vector<Index> divide(std::size_t i, std::function<bool(Index)> is_fixed)
  {
    const Index a = m_tree.merges()[i].kept, b = m_tree.merges()[i].removed;
    std::vector<Index> guests = std::exchange(m_guests[a], {});
    for (const Index guest : guests)
      m_label_of[guest] = none;
    m_elements.for_each(m_elements.removed(i), [&](Index element) { m_label_of[element] = b; });
    make_connected(a, m_elements.kept(i), guests, is_fixed);
    make_connected(b, m_elements.removed(i), guests, is_fixed);
    join_parts(guests, a, b);
    return guests;
  }

  /// Whether both parts of a merge have elements of their own or guests.
  bool have_both_elements(std::size_t i, const std::vector<Index>& guests) const
  {
    bool has_kept = m_elements.has_elements(m_elements.kept(i)),
         has_removed = m_elements.has_elements(m_elements.removed(i));
    for (const Index guest : guests)
      (m_label_of[guest] == m_tree.merges()[i].kept ? has_kept : has_removed) = true;
    return has_kept && has_removed;
  }

  /// A part of several components keeps that with fixed elements, else the largest by area; of
  /// equal ones that of the lowest element. The others become guests.
  void make_connected(Index label, const Tree_elements::Part& part, std::vector<Index>& guests,
                      std::function<bool(Index)> is_fixed)
  {
    if (m_cut.is_connected(label, m_elements.lost(part)))
      return;
    const std::vector<std::vector<Index>> components = m_elements.components(part);
    std::vector<double> areas;
    for (const std::vector<Index>& component : components) {
      areas.push_back(0);
      for (const Index element : component)
        areas.back() += is_fixed(m_region_of[element]) ? std::numeric_limits<double>::infinity()
                                                       : m_areas[element];
    }
    std::size_t largest = 0;
    for (std::size_t i = 1; i < components.size(); ++i)
      if (areas[i] > areas[largest] ||
          (areas[i] == areas[largest] && components[i][0] < components[largest][0]))
        largest = i;
    for (std::size_t i = 0; i < components.size(); ++i)
      if (i != largest) {
        m_elements.remove(components[i]);
        guests.insert(guests.end(), components[i].begin(), components[i].end());
        for (const Index element : components[i])
          m_label_of[element] = none;
      }
  }

  /// In rounds: elements without a label that border on one of the parts join the one with the
  /// dearer border, of equal ones the first.
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

  void move_border(std::size_t i, std::vector<Index>& guests, std::function<double(double)> width,
                   std::function<bool(Index)> is_fixed)
  {
    const Index a = m_tree.merges()[i].kept, b = m_tree.merges()[i].removed;
    std::vector<Index> elements_of_b, border;
    m_elements.for_each(m_elements.removed(i),
                        [&](Index element) { elements_of_b.push_back(element); });
    for (const Index guest : guests)
      if (m_label_of[guest] == b)
        elements_of_b.push_back(guest);
    for (const Index element : elements_of_b) {
      m_area_of[b] += m_areas[element];
      for (const auto& step : m_costs.steps(element))
        if (m_label_of[step.face] == a)
          border.insert(border.end(), {element, step.face});
    }
    m_area_of[a] = (std::max)(0.0, m_area_of[a] - m_area_of[b]);
    const double band_width = width((std::min)(m_area_of[a], m_area_of[b]));
    if (!(band_width > 0))
      return;
    const std::vector<Index> moved = m_cut.move_border(
      a, b, border, band_width, [&](Index element) { return is_fixed(m_region_of[element]); });
    std::vector<Index> lost;
    for (const Index element : moved) {
      const Index now = m_label_of[element];
      m_area_of[now] += m_areas[element];
      m_area_of[now == a ? b : a] -= m_areas[element];
      if (m_elements.has(element))
        lost.push_back(element);
    }
    m_elements.remove(lost);
    guests.insert(guests.end(), lost.begin(), lost.end());
  }

  const Dual_graph& m_costs;
  const std::vector<double>& m_areas;
  const std::vector<Index>& m_region_of;
  const Merge_tree& m_tree;
  Tree_elements m_elements;                 // their own
  std::vector<Index> m_label_of;            // by element: its segment, named by the lowest region
  std::vector<std::vector<Index>> m_guests; // by segment
  std::vector<double> m_area_of;            // by segment, as long as borders are moved
  Border_cut m_cut;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_NESTED_BORDERS_H
