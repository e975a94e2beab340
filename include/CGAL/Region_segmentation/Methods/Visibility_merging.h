// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_MERGING_H
#define CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_MERGING_H

#include <CGAL/Region_segmentation/Methods/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Methods/Number_from_costs.h>
#include <CGAL/Region_segmentation/Methods/Superfacet_merging.h>
#include <CGAL/Region_segmentation/Methods/Visibility_annotator.h>
#include <CGAL/Region_segmentation/Methods/Visibility_cost.h>
#include <CGAL/Region_segmentation/internal/concepts/Method_calls.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationMethods
/// The method with a hand-crafted cost: superfacets, annotated by `Visibility_annotator`, merged at
/// the lowest `Visibility_cost` first, with different constants while there are more than 150
/// regions. A model of `SegmentationMethod`.
struct Visibility_merging
  : Superfacet_merging<
      Visibility_annotator,
      Policy_phases<Lowest_cost_first<Visibility_cost>, Lowest_cost_first<Visibility_cost>>,
      Number_from_costs>
{
  /// The level of `Number_from_costs` for the constants of `Visibility_cost()`.
  static constexpr double default_level = -19.5;

  /// `cost`: for few regions; `cost_of_many`: while there are more than `many` regions
  explicit Visibility_merging(
    const Visibility_cost& cost = Visibility_cost(),
    const Visibility_cost& cost_of_many = Visibility_cost::for_many_regions(),
    std::size_t many = 150)
    : Superfacet_merging{Visibility_annotator(),
                         {{Lowest_cost_first(cost_of_many), many}, {Lowest_cost_first(cost), 1}},
                         Number_from_costs(default_level)}
  {}
};

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template struct internal::Method_calls<Visibility_merging>;
#endif

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_MERGING_H
