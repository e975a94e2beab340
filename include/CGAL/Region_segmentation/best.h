// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_BEST_H
#define CGAL_REGION_SEGMENTATION_BEST_H

#include <CGAL/Region_segmentation/Cut_cost.h>
#include <CGAL/Region_segmentation/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Number_from_costs.h>
#include <CGAL/Region_segmentation/Policy_sequence.h>
#include <CGAL/Region_segmentation/Sight.h>
#include <CGAL/Region_segmentation/Superfacets.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// The most accurate method of the package: `Superfacets`, annotated by `Sight`, merged at the lowest
/// `Cut_cost` first, with other constants while there are more than 150 regions.
///
/// The order of merges does not depend on the wanted number: one tree gives every segmentation, and
/// `Number_from_costs` finds a number where none is wanted.
struct Best
  : Policy_sequence<Lowest_cost_first<Cut_cost>, Lowest_cost_first<Cut_cost>, Switch_at_count>
{
  using RegionInitializer = Superfacets;
  using GraphAnnotator = Sight;
  using NumberChooser = Number_from_costs;

  /// `cost`: of few regions; `cost_of_many`: while there are more than `many` of them
  explicit Best(const Cut_cost& cost = Cut_cost(),
                const Cut_cost& cost_of_many = Cut_cost::for_many_regions(), std::size_t many = 150)
    : Policy_sequence(Lowest_cost_first<Cut_cost>(cost_of_many), Lowest_cost_first<Cut_cost>(cost),
                      Switch_at_count{many})
  {}
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_BEST_H
