// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_REGION_ELEMENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_REGION_ELEMENTS_H

#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The elements that regions still have while they lose some.
class Region_elements
{
public:
  using Index = Dual_graph::Index;

  /// `region_of`: by element
  Region_elements(const Dual_graph& adjacency, const std::vector<Index>& region_of,
                  std::size_t number_of_regions)
    : m_adjacency(adjacency)
    , m_region_of(region_of)
    , m_elements(grouped<Index>(number_of_regions,
                                [&](const auto& add) {
                                  for (std::size_t e = 0; e < region_of.size(); ++e)
                                    add(region_of[e], Index(e));
                                }))
    , m_lost(number_of_regions)
    , m_is_there(region_of.size(), true)
    , m_is_waiting(region_of.size(), false)
  {}

  /// Whether the region of an element still has it.
  bool has(Index element) const { return m_is_there[element]; }
  /// Whether a region has any left.
  bool has_elements(Index region) const
  {
    return m_lost[region].size() < m_elements[region].size();
  }
  /// Those that a region has lost.
  const std::vector<Index>& lost(Index region) const { return m_lost[region]; }

  /// Calls `f(element)` for the elements that a region still has, in order.
  template <typename F>
  void for_each_element(Index region, const F& f) const
  {
    for (const Index element : m_elements[region])
      if (has(element))
        f(element);
  }

  /// Takes elements from their regions.
  void remove(const std::vector<Index>& elements)
  {
    for (const Index element : elements) {
      m_is_there[element] = false;
      m_lost[m_region_of[element]].push_back(element);
    }
  }

  /// The connected components of the elements that regions have together, each in order.
  std::vector<std::vector<Index>> components(const std::vector<Index>& regions)
  {
    std::vector<std::vector<Index>> result;
    for (const Index region : regions)
      for_each_element(region, [&](Index element) { m_is_waiting[element] = true; });
    for (const Index region : regions)
      for_each_element(region, [&](Index element) {
        if (m_is_waiting[element])
          result.push_back(waiting_component(element));
      });
    return result;
  }

private:
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
  Grouped_items<Index> m_elements;            // by region, those that it lost included
  std::vector<std::vector<Index>> m_lost;     // by region
  std::vector<char> m_is_there, m_is_waiting; // by element; to be reached by a search
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_REGION_ELEMENTS_H
