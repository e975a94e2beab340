// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_TREE_ELEMENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_TREE_ELEMENTS_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>

#include <algorithm>
#include <cstddef>
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

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_TREE_ELEMENTS_H
