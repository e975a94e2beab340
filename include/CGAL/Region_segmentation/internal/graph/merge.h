// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_MERGE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_MERGE_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/concepts/check_merging.h>
#include <CGAL/Region_segmentation/internal/support/visitor.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Merges the regions of a graph in the order of a policy, until `stop` returns `true` or the policy has no further
/// candidate. `on_merge(merge)` is called after each merge, before that of the policy.
/// \throws Invalid_method if the policy proposes a section that is removed or not mergeable, or a cost that is not a number
template <typename Graph, typename Policy, typename Stop, typename OnMerge, typename ConcurrencyTag>
Merge_tree merge(Graph& graph, Policy& policy, std::size_t number_of_segments, Stop& stop, const OnMerge& on_merge,
                 const Execution<ConcurrencyTag>& execution)
{
  Merge_tree tree(graph.index_bound_of_regions());
  Step_counter<ConcurrencyTag> merges(
    execution, graph.number_of_regions() - (std::min)(graph.number_of_regions(), number_of_segments));
  initialize_policy(policy, graph, number_of_segments);
  while (const auto candidate = policy.next(graph)) {
    if (stop(graph, candidate->cost))
      break;
    if (graph.is_removed(candidate->section) || !graph.is_mergeable(candidate->section))
      throw Invalid_method("the RegionMergingPolicy proposes to merge across section " +
                           std::to_string(candidate->section.id()) + ", which is " +
                           (graph.is_removed(candidate->section) ? "removed" : "not mergeable"));
    if (std::isnan(candidate->cost))
      throw Invalid_method("the RegionMergingPolicy proposes to merge across section " +
                           std::to_string(candidate->section.id()) + " at a cost that is not a number");
    const auto merge = graph.merge(candidate->section);
    on_merge(merge);
    policy.on_merge(graph, merge);
    tree.push_back({merge.kept, merge.removed, candidate->cost});
    merges.advance();
  }
  return tree;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_MERGE_H
