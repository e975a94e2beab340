// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_NUMBER_FROM_COSTS_H
#define CGAL_REGION_SEGMENTATION_METHODS_NUMBER_FROM_COSTS_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Methods/Number_range.h>
#include <CGAL/Region_segmentation/internal/regions/is_convex.h>

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
/// With \f$c_k\f$ the largest cost of a merge down to \f$k - 1\f$ regions, from `maximum_number`
/// regions on, and \f$c\f$ that of the last merge, the number is the largest \f$k\f$ for which all
/// of \f$c_2 .. c_k\f$ are above the mean of \f$c\f$ and `level`, less the logarithm of
/// `granularity`; within `Number_range`.
///
/// Complexity: O(m), m the larger of `maximum_number` and the number of connected pieces.
class Number_from_costs : public Number_range
{
public:
  double level; ///< in the units of the costs
  /// How much finer, more than 0: its logarithm is taken from the bound, so costs count as if that
  /// factor larger. 1 as fits the method, 2 finer, 0.5 coarser. The number never falls when it
  /// rises.
  double granularity = 1;

  explicit Number_from_costs(double level_, std::size_t maximum_number_ = 40)
    : Number_range(maximum_number_)
    , level(level_)
  {}

  std::size_t operator()(const Merge_tree& tree, const Surface& mesh = Surface()) const
  {
    if (internal::is_convex(mesh))
      return number_of_convex(tree, mesh);
    const std::size_t leaves = tree.number_of_regions();
    const std::size_t least = least_number(tree);
    // The merge from k to k - 1 regions has the index leaves - k.
    const auto first = tree.merges().begin() + std::ptrdiff_t(leaves - largest_number(tree));
    const auto end = tree.merges().end();
    if (first == end)
      return least;
    const auto highest = std::max_element(
      first, end,
      [](const Merge_tree::Merge& a, const Merge_tree::Merge& b) { return a.cost < b.cost; });
    const double threshold = (level + highest->cost) / 2 - std::log(granularity);
    const auto above = std::find_if(first, end,
                                    [=](const Merge_tree::Merge& m) { return m.cost > threshold; });
    const std::size_t number = leaves - std::size_t(above - tree.merges().begin());
    return (std::max)(number, least);
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_NUMBER_FROM_COSTS_H
