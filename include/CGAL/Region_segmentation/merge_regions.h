// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_MERGE_REGIONS_H
#define CGAL_REGION_SEGMENTATION_MERGE_REGIONS_H

#include <CGAL/Region_segmentation/Merge_candidate.h>
#include <CGAL/Region_segmentation/Merge_tree.h>
#include <CGAL/Region_segmentation/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/internal/concept_checks.h>
#include <CGAL/Region_segmentation/internal/progress.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// Stops when a number of regions is reached. A model of `MergingStopPredicate`.
struct Stop_at_count
{
  std::size_t number_of_regions;

  template <typename Graph>
  bool operator()(const Graph& graph, double /* next_cost */) const
  {
    return graph.number_of_regions() <= number_of_regions;
  }
};

/// \ingroup PkgRegionSegmentationPolicies
/// Stops before the first merge that costs more. A model of `MergingStopPredicate`.
struct Stop_at_cost
{
  double maximum_cost;

  template <typename Graph>
  bool operator()(const Graph&, double next_cost) const
  {
    return next_cost > maximum_cost;
  }
};

/// \ingroup PkgRegionSegmentationStages
/// merges the regions of a graph, one section at a time, in the order of a policy.
///
/// The run ends when `stop` says so or the policy has nothing left to merge.
///
/// \tparam Graph a `Region_adjacency_graph`
/// \tparam Policy a model of `RegionMergingPolicy`
/// \tparam Stop a model of `MergingStopPredicate`
/// \param graph the regions; merged in place
/// \param policy is initialized for `number_of_segments`
/// \param number_of_segments what the policy is told is wanted; `stop` decides
/// \param stop is asked before each merge
/// \param np optional named parameters:
///   - `visitor`: a model of `SegmentationVisitor`, told of the stage "merging"
///
/// \returns the tree of the merges, over all indices of regions of the graph
/// \throws Segmentation_cancelled if the visitor says so; the graph is left between two merges then
///
/// Complexity: that of the policy, and O((R + S) log R) expected for the graph itself. Deterministic.
template <typename Graph, typename Policy, typename Stop,
          typename NamedParameters = parameters::Default_named_parameters>
Merge_tree merge_regions(Graph& graph, Policy& policy, std::size_t number_of_segments, Stop stop,
                         const NamedParameters& np = parameters::default_values())
{
  internal::check_merging_policy<Policy, Graph>();
  internal::check_stop_predicate<Stop, Graph>();

  Merge_tree tree(graph.index_bound_of_regions());
  internal::Progress progress(internal::pack(np), "merging",
                              graph.number_of_regions() - (std::min)(graph.number_of_regions(),
                                                                     number_of_segments));
  policy.initialize(graph, number_of_segments);
  while (const auto candidate = policy.next(graph)) {
    if (stop(graph, candidate->cost))
      break;
    const auto merge = graph.merge(candidate->section);
    policy.on_merge(graph, merge);
    tree.push_back({merge.kept, merge.removed, candidate->cost});
    progress.advance();
  }
  return tree;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_MERGE_REGIONS_H
