// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_NUMBER_FROM_EXPECTED_COSTS_H
#define CGAL_REGION_SEGMENTATION_METHODS_NUMBER_FROM_EXPECTED_COSTS_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Methods/Number_range.h>
#include <CGAL/Region_segmentation/internal/regions/is_convex.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// chooses the number of segments from a merge tree whose costs can be added: that at which the sum
/// of the costs, from `maximum_number` regions on, is lowest. A model of `NumberChooser`, for costs
/// that are below 0 where a merge pays, such as `Expected_merge_cost`.
///
/// The number is within `Number_range`. It is the largest of several.
///
/// Complexity: O(m), m the larger of `maximum_number` and the number of connected components.
class Number_from_expected_costs : public Number_range
{
public:
  /// How much finer, more than 0: the factor by which costs above 0, of merges that do not pay, are
  /// multiplied. 1 as fits the method, 2 finer, 0.5 coarser. The number never falls when it rises.
  double granularity = 1;

  explicit Number_from_expected_costs(std::size_t maximum_number_ = 40)
    : Number_range(maximum_number_)
  {}

  std::size_t operator()(const Merge_tree& tree, const Surface& mesh = Surface()) const
  {
    if (internal::is_convex(mesh))
      return number_of_convex(tree, mesh);
    const std::size_t least = least_number(tree);
    std::size_t best = (std::max)(least, largest_number(tree));
    double sum = 0, lowest = 0;
    for (std::size_t n = best; n > least; --n) {
      // The merge from n to n - 1 regions.
      const double cost = tree.merges()[tree.number_of_regions() - n].cost;
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

#endif // CGAL_REGION_SEGMENTATION_METHODS_NUMBER_FROM_EXPECTED_COSTS_H
