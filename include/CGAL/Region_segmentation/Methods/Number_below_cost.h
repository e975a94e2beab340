// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_NUMBER_BELOW_COST_H
#define CGAL_REGION_SEGMENTATION_METHODS_NUMBER_BELOW_COST_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Surface.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// chooses the number of segments before the first merge that costs more than a bound. A model of
/// `NumberChooser`, for costs that mean the same on every mesh, such as `Surface_face_cost`.
///
/// Complexity: O(R).
struct Number_below_cost
{
  double bound; ///< in the units of the costs

  std::size_t operator()(const Merge_tree& tree, const Surface&) const
  {
    const auto above = std::find_if(
      tree.merges().begin(), tree.merges().end(),
      [this](const Merge_tree::Merge& merge) { return merge.cost > bound; });
    return tree.number_of_regions() - std::size_t(above - tree.merges().begin());
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_NUMBER_BELOW_COST_H
