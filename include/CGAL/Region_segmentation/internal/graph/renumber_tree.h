// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_RENUMBER_TREE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_RENUMBER_TREE_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Hierarchy.h>
#include <CGAL/Region_segmentation/Partition.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The tree of regions that have new numbers, or no elements any more (the highest number): their
/// merges are left out.
inline Merge_tree renumber_tree(const Merge_tree& tree, std::vector<Partition::Index> new_numbers)
{
  constexpr Partition::Index none = (std::numeric_limits<Partition::Index>::max)();
  Merge_tree result(std::size_t(std::count_if(new_numbers.begin(), new_numbers.end(),
                                              [](auto number) { return number != none; })));
  for (const Merge_tree::Merge& merge : tree.merges()) {
    // Of each segment, the lowest of the new numbers.
    Partition::Index& kept = new_numbers[merge.kept];
    const Partition::Index removed = new_numbers[merge.removed];
    if (kept != none && removed != none)
      result.push_back({(std::min)(kept, removed), (std::max)(kept, removed), merge.cost});
    kept = (std::min)(kept, removed);
  }
  return result;
}

/// The hierarchy of regions whose faces were moved between them: `region_of` gives the region of
/// each face by the numbers of `tree`.
inline Hierarchy renumbered_hierarchy(const std::vector<Partition::Index>& region_of,
                                      const Merge_tree& tree, std::size_t number_of_segments)
{
  constexpr Partition::Index none = (std::numeric_limits<Partition::Index>::max)();
  Partition regions = Partition::from_labels(region_of);
  std::vector<Partition::Index> new_numbers(tree.number_of_regions(), none);
  for (std::size_t f = 0; f < region_of.size(); ++f)
    new_numbers[region_of[f]] = regions[f];
  return Hierarchy(std::move(regions), renumber_tree(tree, std::move(new_numbers)),
                   number_of_segments);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_RENUMBER_TREE_H
