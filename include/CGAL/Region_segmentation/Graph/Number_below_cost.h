// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_BELOW_COST_H
#define CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_BELOW_COST_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

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

  /// \throws Invalid_method if a constant is not in its range
  void check_constants() const
  {
    internal::check_constant("Number_below_cost: bound", bound, -internal::greatest_finite);
  }

  std::size_t operator()(const Merge_tree& tree, const Surface&) const
  {
    return tree.number_at_cost(bound);
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_BELOW_COST_H
