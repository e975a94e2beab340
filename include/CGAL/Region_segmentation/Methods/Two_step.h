// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_TWO_STEP_H
#define CGAL_REGION_SEGMENTATION_METHODS_TWO_STEP_H

#include <CGAL/Region_segmentation/Methods/Geometry_annotator.h>
#include <CGAL/Region_segmentation/Methods/Least_compact_region_first.h>
#include <CGAL/Region_segmentation/Methods/Policy_sequence.h>
#include <CGAL/Region_segmentation/Methods/Region_growing.h>
#include <CGAL/Region_segmentation/Methods/Segmentation_method.h>
#include <CGAL/Region_segmentation/Methods/Smallest_region_first.h>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// The merging of the paper: `Smallest_region_first` while there are more than `factor` times the
/// wanted number of regions, then `Least_compact_region_first`. A model of `RegionMergingPolicy`.
///
/// The order of merges depends on the wanted number, so its tree is valid for that number only.
struct Two_step_merging
  : Policy_sequence<Smallest_region_first, Least_compact_region_first, Switch_at_multiple>
{
  /// `beta`: the weight of a section's length against its flatness, in [0, 1];
  /// `gamma`: the weight of a region's planarity against its area, in [0, 1];
  /// `factor`: the number of regions after step one, as a multiple of the wanted number of segments, at least 1
  explicit Two_step_merging(double beta = 0.1, double gamma = 0.6, double factor = 2)
    : Policy_sequence(Smallest_region_first(beta), Least_compact_region_first(beta, gamma),
                      Switch_at_multiple{factor})
  {}
};

/// \ingroup PkgRegionSegmentationMethods
/// The method of the paper: `Region_growing` between feature edges, merged by `Two_step_merging`. A model of
/// `SegmentationMethod`.
///
/// It requires the number of segments.
///
/// Source: \cgalCite{YZWLL14}.
struct Two_step : Segmentation_method<Region_growing, Geometry_annotator<>, Two_step_merging>
{
  Two_step() = default;

  /// With the constants of `Two_step_merging`.
  explicit Two_step(double beta, double gamma = 0.6, double factor = 2)
  {
    policy = Two_step_merging(beta, gamma, factor);
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_TWO_STEP_H
