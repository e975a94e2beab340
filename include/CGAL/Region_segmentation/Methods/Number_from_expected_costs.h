// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_NUMBER_FROM_EXPECTED_COSTS_H
#define CGAL_REGION_SEGMENTATION_METHODS_NUMBER_FROM_EXPECTED_COSTS_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// chooses the number of segments from a merge tree whose costs can be added: that at which the sum of the costs, from
/// `maximum_number` regions on, is lowest. A model of `NumberChooser`, for costs that are below 0 where a merge pays,
/// such as `Expected_merge_cost`.
///
/// The number is at least 2, if the tree has 2, and at least the number of connected components; the largest of several.
///
/// Complexity: O(m), m the larger of `maximum_number` and the number of connected components.
///
/// \tparam Cost the cost in whose units the sums are: a method that merges by another one does not compile
template <typename Cost>
class Number_from_expected_costs
{
public:
  using MergeCost = Cost;

  std::size_t maximum_number; ///< of segments, at least 2

  explicit Number_from_expected_costs(std::size_t maximum_number_ = 40) : maximum_number(maximum_number_) {}

  std::size_t operator()(const Merge_tree& tree) const { return number(tree.merges(), tree.number_of_regions()); }

  /// As above, for the last merges of a tree: `number_of_regions` were left before them.
  std::size_t number(const std::vector<Merge_tree::Merge>& merges, std::size_t number_of_regions) const
  {
    const std::size_t least = (std::max)(number_of_regions - merges.size(), (std::min)(number_of_regions, std::size_t(2)));
    std::size_t best = (std::max)(least, (std::min)(number_of_regions, maximum_number));
    double sum = 0, lowest = 0;
    for (std::size_t n = best; n > least; --n) {
      // The merge from n to n - 1 regions.
      sum += merges[number_of_regions - n].cost;
      if (sum < lowest) {
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
