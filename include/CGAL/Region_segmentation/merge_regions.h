// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_MERGE_REGIONS_H
#define CGAL_REGION_SEGMENTATION_MERGE_REGIONS_H

#include <CGAL/Region_segmentation/Graph/Merge_candidate.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/internal/graph/merge_graph.h>
#include <CGAL/Region_segmentation/internal/support/make_execution.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationStages
/// merges the regions of a graph, one section at a time, in the order of a policy, until
/// `number_of_segments` are left or the policy has no further candidate.
///
/// To stop at a cost, merge all of them, and ask the tree: `Merge_tree::partition_at_cost()`. A
/// graph that is partly merged is merged further, by the same policy or another one.
///
/// \tparam Graph a `Region_adjacency_graph`
/// \tparam Policy a model of `MergingPolicy`, or `Policy_phases`
/// \param graph the regions; merged in place
/// \param policy determines the order of merges
/// \param number_of_segments the wanted number of regions
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the progress, and can cancel: stages "merging"}
///     \cgalParamType{a model of `SegmentationVisitor`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{passed by `std::ref()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the tree of the merges of this call, over all indices of regions of the graph
/// \throws Segmentation_cancelled if the visitor cancels, Invalid_method if the policy proposes a
///         section that is removed or not mergeable, or a cost that is not a number; the graph is
///         then in the state between two merges
///
/// Complexity: that of the policy, and O((R + S) log R) for the graph itself in practice.
/// Deterministic.
template <typename Graph, typename Policy,
          typename NamedParameters = parameters::Default_named_parameters>
Merge_tree merge_regions(Graph& graph, Policy policy, std::size_t number_of_segments,
                         const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>,
                             internal::Tag_list<CGAL::internal_np::visitor_t>>();
  internal::Merger<Graph> merger(
    graph, Seeds(), number_of_segments,
    internal::make_execution<CGAL::Sequential_tag>(pack).stage("merging"));
  merger.run(policy);
  return merger.take_tree();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_MERGE_REGIONS_H
