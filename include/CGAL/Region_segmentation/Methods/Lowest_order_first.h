// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_LOWEST_ORDER_FIRST_H
#define CGAL_REGION_SEGMENTATION_METHODS_LOWEST_ORDER_FIRST_H

#include <CGAL/Region_segmentation/Graph/Merge_candidate.h>
#include <CGAL/Region_segmentation/Methods/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/internal/concepts/check_parts.h>

#include <optional>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// Merges in the order of one cost, and records another one as the costs of the merges. A model of
/// `MergingPolicy`.
///
/// The best next merge is not always the one whose cost should be added up to choose a number of
/// segments.
///
/// Complexity: that of `Lowest_cost_first<Order>`, and one evaluation of `Cost` per merge.
///
/// \tparam Order a model of `SectionCost`: the section for which it is lowest is merged across next
/// \tparam Cost a model of `SectionCost`, recorded for each merge; a number for every section that
///         `Order` does not bar
template <typename Order, typename Cost>
class Lowest_order_first : public Lowest_cost_first<Order>
{
public:
  Lowest_order_first(Order order, Cost cost)
    : Lowest_cost_first<Order>(std::move(order))
    , m_cost(std::move(cost))
  {}

  void check_constants() const
  {
    Lowest_cost_first<Order>::check_constants();
    internal::check_constants(m_cost);
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    static_assert(internal::check_section_cost<Cost, Graph>());
    std::optional<Merge_candidate> candidate = Lowest_cost_first<Order>::next(graph);
    if (candidate)
      candidate->cost = m_cost(graph, candidate->section);
    return candidate;
  }

private:
  Cost m_cost;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_LOWEST_ORDER_FIRST_H
