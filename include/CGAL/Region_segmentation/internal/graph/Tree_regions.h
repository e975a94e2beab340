// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_TREE_REGIONS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_TREE_REGIONS_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Partition.h>

#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A merge tree from its roots down: the regions of both parts of each merge.
class Tree_regions
{
public:
  using Index = Partition::Index;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  explicit Tree_regions(const Merge_tree& tree)
    : m_tree(tree)
    , m_next(tree.number_of_regions(), Index(none))
  {
    std::vector<Index> last(tree.number_of_regions());
    std::iota(last.begin(), last.end(), Index(0));
    for (std::size_t i = 0; i < tree.merges().size(); ++i) {
      const Merge_tree::Merge& merge = tree.merges()[i];
      m_end_of_removed.push_back(last[merge.removed]);
      m_next[last[merge.kept]] = merge.removed;
      last[merge.kept] = last[merge.removed];
    }
    // What follows the last region of a part is known now.
    for (Index& last_of_removed : m_end_of_removed)
      last_of_removed = m_next[last_of_removed];
  }

  /// Calls `f(region)` for the regions of the part that a merge keeps.
  template <typename F>
  void for_each_kept(std::size_t merge, const F& f) const
  {
    const auto& [kept, removed, cost] = m_tree.merges()[merge];
    for (Index r = kept; r != removed; r = m_next[r])
      f(r);
  }

  template <typename F>
  void for_each_removed(std::size_t merge, const F& f) const
  {
    for (Index r = m_tree.merges()[merge].removed; r != m_end_of_removed[merge]; r = m_next[r])
      f(r);
  }

private:
  const Merge_tree& m_tree;
  std::vector<Index> m_next; // lists of the regions of each segment: those kept, then those removed
  std::vector<Index> m_end_of_removed; // by merge: what follows its removed regions in their list
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_TREE_REGIONS_H
