// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_LOWEST_COST_FIRST_H
#define CGAL_REGION_SEGMENTATION_METHODS_LOWEST_COST_FIRST_H

#include <CGAL/Region_segmentation/Graph/Merge_candidate.h>
#include <CGAL/Region_segmentation/internal/concepts/check_graph_data.h>
#include <CGAL/Region_segmentation/internal/concepts/check_merging.h>
#include <CGAL/Region_segmentation/internal/graph/Section_queue.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// Turns a cost of sections into a policy: merges across the cheapest section of the graph next; of
/// equal ones, the one between the lower regions. A model of `MergingPolicy`.
///
/// A merge changes only the costs of the sections of the merged region: a cost may depend on a
/// section and on its two regions.
///
/// All of them are computed anew, unless the region is a hub of more than `hub_degree` sections:
/// then those that the merge moved or united, and all others after every (degree / `hub_degree`)th
/// merge of the region, rounded down. So a hub takes linear time, while the cost of a section at
/// its rim lags behind by a small share of its merges.
///
/// Complexity: O(min(d, `hub_degree`) log S) per merge, amortized, d the number of sections of the
/// merged region.
///
/// A lambda is a cost, too: `Lowest_cost_first([](const auto& graph, auto s) { return
/// graph[s].length; })`.
///
/// \tparam Cost a model of `SectionCost`; a section whose cost is not a number is never merged
///         across
template <typename Cost>
class Lowest_cost_first : public internal::Data_named_by<Cost>
{
public:
  static constexpr std::size_t hub_degree = internal::Section_queue::hub_degree;

  explicit Lowest_cost_first(Cost cost = Cost())
    : m_cost(std::move(cost))
  {}

  template <typename Graph>
  void initialize(const Graph& graph)
  {
    static_assert(internal::check_section_cost<Cost, Graph>());
    m_sections.initialize(graph, [&](Section_descriptor s) { return m_cost(graph, s); });
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    return m_sections.next(graph);
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    m_sections.on_merge(graph, merge, [&](Section_descriptor s) { return m_cost(graph, s); });
  }

private:
  Cost m_cost;
  internal::Section_queue m_sections;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_LOWEST_COST_FIRST_H
