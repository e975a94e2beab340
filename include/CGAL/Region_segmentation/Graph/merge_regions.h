// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_MERGE_REGIONS_H
#define CGAL_REGION_SEGMENTATION_GRAPH_MERGE_REGIONS_H

#include <CGAL/Region_segmentation/Graph/Hierarchy.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Merges the regions of a graph and records the merges. Regions of different seeds are not merged.
template <typename Graph>
class Merger
{
public:
  /// `number`: merging ends when this number of regions is left
  Merger(Graph& graph, const Seeds& of_regions, std::size_t number, const Execution& execution)
    : m_graph(graph)
    , m_number(number)
    , m_seeds(of_regions)
    , m_tree(graph.index_bound_of_regions())
    , m_progress(execution,
                 graph.number_of_regions() - (std::min)(graph.number_of_regions(), number))
  {
    if (!m_seeds.empty())
      for (auto range = edges(graph); range.first != range.second; ++range.first)
        bar_if_between_seeds(*range.first);
  }

  /// Merges the given pairs of first regions, one after the other, if their section is mergeable.
  void merge_first(const std::vector<std::pair<Partition::Index, Partition::Index>>& pairs)
  {
    Lowest_root_forest kept(m_graph.index_bound_of_regions());
    for (const auto& [r, s] : pairs) {
      const Partition::Index a = kept.root(r), b = kept.root(s);
      if (a == b || m_graph.number_of_regions() <= m_number)
        continue;
      if (const auto section = m_graph.section(a, b); section && m_graph.is_mergeable(*section)) {
        merge(*section, Merge_tree::least_cost);
        kept.unite(a, b);
      }
    }
  }

  /// Merges in the order of a policy until `number` regions are left, or the number of the
  /// constructor if that is larger. Returns `false` if the policy has no candidate before that.
  /// \throws Invalid_method if the policy proposes a section that is removed or not mergeable, or a
  ///         cost that is not a number
  template <typename Policy>
  bool run(Policy& policy, std::size_t number = 0)
  {
    number = (std::max)(number, m_number);
    if (m_graph.number_of_regions() <= number)
      return true; // initializing a policy can take quadratic time
    policy.initialize(m_graph);
    while (m_graph.number_of_regions() > number) {
      const auto candidate = policy.next(m_graph);
      if (!candidate)
        return false;
      check(*candidate);
      policy.on_merge(m_graph, merge(candidate->section, candidate->cost));
    }
    return true;
  }

  template <typename... Policies>
  bool run(Policy_phases<Policies...>& phases)
  {
    return std::apply(
      [this](auto&... phase) { return (this->run(phase.first, phase.second) && ...); }, phases);
  }

  Merge_tree take_tree() { return std::move(m_tree); }

private:
  typename Graph::Merge merge(typename Graph::section_descriptor section, double cost)
  {
    const auto merge = m_graph.merge(section);
    bar_after(merge);
    m_tree.push_back({merge.kept, merge.removed, cost});
    m_progress.advance();
    return merge;
  }

  void bar_after(const typename Graph::Merge& merge)
  {
    if (m_seeds.empty())
      return;
    Seeds::Index& kept = m_seeds.of[merge.kept];
    if (kept == Seeds::none)
      kept = m_seeds.of[merge.removed];
    if (kept != Seeds::none)
      for (auto s : m_graph.sections(merge.kept))
        bar_if_between_seeds(s);
  }

  void bar_if_between_seeds(typename Graph::section_descriptor s)
  {
    const Seeds::Index a = m_seeds.of[m_graph.source(s)], b = m_seeds.of[m_graph.target(s)];
    if (a != b && a != Seeds::none && b != Seeds::none)
      m_graph.forbid_merge(s);
  }

  template <typename Candidate>
  void check(const Candidate& candidate) const
  {
    const bool is_removed = m_graph.is_removed(candidate.section);
    if (!is_removed && m_graph.is_mergeable(candidate.section) && !std::isnan(candidate.cost))
      return;
    throw Invalid_method("the MergingPolicy proposes to merge across section " +
                         std::to_string(candidate.section.id()) +
                         (is_removed ? ", which is removed"
                          : !m_graph.is_mergeable(candidate.section)
                            ? ", which is not mergeable"
                            : " at a cost that is not a number"));
  }

  Graph& m_graph;
  const std::size_t m_number;
  Seeds m_seeds; // of the regions
  Merge_tree m_tree;
  Step_counter m_progress;
};

} // namespace internal

/// \ingroup PkgRegionSegmentationStages
/// merges the regions of a graph, one section at a time, in the order of a policy, until
/// `number_of_segments` are left or the policy has no further candidate.
///
/// To stop at a cost, merge all regions and call `Merge_tree::partition_at_cost()`. A graph whose
/// regions were merged before can be merged further, by the same policy or another one.
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

#endif // CGAL_REGION_SEGMENTATION_GRAPH_MERGE_REGIONS_H
