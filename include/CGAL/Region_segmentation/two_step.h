// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TWO_STEP_H
#define CGAL_REGION_SEGMENTATION_TWO_STEP_H

#include <CGAL/Region_segmentation/Least_compact_region_first.h>
#include <CGAL/Region_segmentation/Policy_sequence.h>
#include <CGAL/Region_segmentation/Smallest_region_first.h>
#include <CGAL/Region_segmentation/grow_regions.h>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// The merging of the paper: `Smallest_region_first` while more than `factor` times the wanted number
/// of regions are left, then `Least_compact_region_first`.
///
/// The order of merges depends on the wanted number, so its tree serves that number alone.
struct Two_step
  : Policy_sequence<Smallest_region_first, Least_compact_region_first, Switch_at_multiple>
{
  using RegionInitializer = Region_growing;

  /// `beta`: the weight of a section's length against its flatness, in [0, 1];
  /// `gamma`: the weight of a region's planarity against its area, in [0, 1];
  /// `factor`: how many times the wanted number of segments step one leaves, at least 1
  explicit Two_step(double beta = 0.1, double gamma = 0.6, double factor = 2)
    : Policy_sequence(Smallest_region_first(beta), Least_compact_region_first(beta, gamma),
                      Switch_at_multiple{factor})
  {}
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TWO_STEP_H
