// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_FROM_COSTS_H
#define CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_FROM_COSTS_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Graph/Number_range.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// chooses the number of segments from a merge tree: merging ends where costs become high, compared
/// with the highest cost of all. A model of `NumberChooser`, for costs on a logarithmic scale such
/// as `Visibility_cost`.
///
/// Let \f$c_k\f$ be the cost of the merge from \f$k\f$ regions to \f$k - 1\f$, \f$c\f$ the highest
/// of these costs from `maximum_number` regions on, and \f$g\f$ the `granularity`. The number is
/// the largest \f$k\f$ in `Number_range` for which \f$c_k > (c + l) / 2 - \ln g\f$, \f$l\f$ the
/// `level`, or the least number of the range if there is none.
///
/// Complexity: O(m), m the larger of `maximum_number` and the number of connected pieces.
struct Number_from_costs : Number_range
{
  double level; ///< in the units of the costs

  explicit Number_from_costs(double level_)
    : level(level_)
  {}

  /// \throws Invalid_method if a constant is not in its range
  void check_constants() const
  {
    Number_range::check_constants();
    internal::check_constant("Number_from_costs: level", level, -internal::greatest_finite);
  }

  std::size_t operator()(const Merge_tree& tree, const Surface& mesh = Surface()) const
  {
    const auto [least, largest] = range(tree, mesh);
    double highest = Merge_tree::least_cost;
    for (std::size_t n = largest; n > number_of_pieces(tree); --n)
      highest = (std::max)(highest, cost_of_merge(tree, n));
    const double threshold = (level + highest) / 2 - std::log(granularity);
    std::size_t number = largest;
    while (number > least && !(cost_of_merge(tree, number) > threshold))
      --number;
    return number;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_FROM_COSTS_H
