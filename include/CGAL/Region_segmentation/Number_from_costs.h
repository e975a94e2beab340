// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_NUMBER_FROM_COSTS_H
#define CGAL_REGION_SEGMENTATION_NUMBER_FROM_COSTS_H

#include <CGAL/Region_segmentation/Merge_tree.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// chooses the number of segments from a merge tree: merging ends where it becomes dear, compared with
/// the dearest merge of all. A model of `NumberChooser`, for costs on a logarithmic scale such as
/// `Cut_cost`.
///
/// With \f$c_k\f$ the largest cost of a merge down to \f$k - 1\f$ regions, from `maximum_number` regions
/// on, and \f$c\f$ that of the last merge, the number is the largest \f$k\f$ for which all of
/// \f$c_2 .. c_k\f$ are above the mean of \f$c\f$ and `level`; at least 2, if the tree has 2, and at
/// least the number of connected pieces. A surface without any feature (a sphere) gives 2.
///
/// Complexity: O(`maximum_number`).
class Number_from_costs
{
public:
  /// `level`: in the units of the costs; `maximum_number`: of segments, at least 2
  explicit Number_from_costs(double level = -19.5, std::size_t maximum_number = 40)
    : m_level(level), m_maximum_number(maximum_number)
  {}

  std::size_t operator()(const Merge_tree& tree) const
  {
    const std::size_t leaves = tree.number_of_regions();
    const std::size_t least = leaves - tree.merges().size();
    // The merge from k to k - 1 regions has the index leaves - k.
    const std::size_t first = leaves - (std::min)(leaves, (std::max)(m_maximum_number, least));
    std::size_t number = least;
    if (first == tree.merges().size())
      return number;
    const double threshold = (m_level + largest_cost(tree, first, tree.merges().size())) / 2;
    while (leaves - number > first &&
           largest_cost(tree, first, leaves - number) > threshold)
      ++number;
    return (std::max)(number, (std::min)(leaves, std::size_t(2)));
  }

private:
  static double largest_cost(const Merge_tree& tree, std::size_t first, std::size_t last)
  {
    const auto begin = tree.merges().begin();
    return std::max_element(begin + first, begin + last,
                            [](const Merge_tree::Merge& a, const Merge_tree::Merge& b) {
                              return a.cost < b.cost;
                            })
      ->cost;
  }

  double m_level;
  std::size_t m_maximum_number;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_NUMBER_FROM_COSTS_H
