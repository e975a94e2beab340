// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_FROM_EXPECTED_COSTS_H
#define CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_FROM_EXPECTED_COSTS_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Graph/Number_range.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// chooses the number of segments from a merge tree whose costs can be added: that at which the sum
/// of the costs, from `maximum_number` regions on, is lowest. A model of `NumberChooser`, for costs
/// that are below 0 where a merge pays, such as `Learned_cost::recorded_cost()`.
///
/// The number is within `Number_range`. Of several such numbers, the largest is taken. Costs above
/// 0, of merges that do not pay, are multiplied by `granularity`.
///
/// Complexity: O(m), m the larger of `maximum_number` and the number of connected pieces.
struct Number_from_expected_costs : Number_range
{
  std::size_t operator()(const Merge_tree& tree, const Surface& mesh = Surface()) const
  {
    const auto [least, largest] = range(tree, mesh);
    std::size_t best = largest;
    double sum = 0, lowest = 0;
    for (std::size_t n = largest; n > least; --n) {
      const double cost = cost_of_merge(tree, n);
      const bool is_of_crumbs = cost == Merge_tree::least_cost;
      if (!is_of_crumbs)
        sum += cost > 0 ? granularity * cost : cost;
      if (sum < lowest || is_of_crumbs) {
        lowest = sum;
        best = n - 1;
      }
    }
    return best;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_FROM_EXPECTED_COSTS_H
