// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_LEARNED_MERGING_H
#define CGAL_REGION_SEGMENTATION_METHODS_LEARNED_MERGING_H

#include <CGAL/Region_segmentation/Methods/Learned_annotator.h>
#include <CGAL/Region_segmentation/Methods/Learned_cost.h>
#include <CGAL/Region_segmentation/Methods/Learned_data.h>
#include <CGAL/Region_segmentation/Methods/Lowest_order_first.h>
#include <CGAL/Region_segmentation/Methods/Merge_features.h>
#include <CGAL/Region_segmentation/Methods/Number_from_expected_costs.h>
#include <CGAL/Region_segmentation/Methods/Superfacet_merging.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/internal/concepts/Method_calls.h>
#include <CGAL/Region_segmentation/internal/model/learned_merge_model.h>

#include <cstddef>
#include <tuple>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationMethods
/// The default method: superfacets, annotated by `Learned_annotator`, merged as in
/// `Visibility_merging` until few regions are left, and those by `Learned_cost`. A model of
/// `SegmentationMethod`.
///
/// The costs of the later merges are `Expected_merge_cost`; those of the earlier ones,
/// `Visibility_cost`, have other units.
struct Learned_merging
  : Superfacet_merging<
      Learned_annotator,
      Policy_phases<Lowest_cost_first<Visibility_cost>, Lowest_cost_first<Visibility_cost>,
                    Lowest_order_first<Learned_cost, Expected_merge_cost>>,
      Number_from_expected_costs>
{
  /// The number of regions from which on the learned model merges: the model was trained for it.
  /// The largest number that is chosen.
  static constexpr std::size_t few = 60;

  /// `model`: another one than that of the package; it must exist as long as the method
  explicit Learned_merging(const Merge_features::Model& model = internal::learned_merge_model)
    : Superfacet_merging{Learned_annotator(),
                         {std::get<0>(Visibility_merging().policy),
                          {Lowest_cost_first(Visibility_cost()), few},
                          {Lowest_order_first(Learned_cost(model), Expected_merge_cost(model)), 1}},
                         Number_from_expected_costs(few)}
  {}
};

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template struct internal::Method_calls<Learned_merging>;
#endif

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_LEARNED_MERGING_H
