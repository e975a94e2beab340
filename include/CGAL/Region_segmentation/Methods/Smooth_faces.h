// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SMOOTH_FACES_H
#define CGAL_REGION_SEGMENTATION_METHODS_SMOOTH_FACES_H

#include <CGAL/Region_segmentation/Methods/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Methods/Number_below_cost.h>
#include <CGAL/Region_segmentation/Methods/Region_growing.h>
#include <CGAL/Region_segmentation/Methods/Segmentation_method.h>
#include <CGAL/Region_segmentation/Methods/Smoothness_annotator.h>
#include <CGAL/Region_segmentation/Methods/Smoothness_cost.h>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationMethods
/// The smooth faces of a machine part, between its creases and where fillets begin: `Region_growing` of plane facets,
/// annotated by `Smoothness_annotator`, merged at the lowest `Smoothness_cost` first. A model of `SegmentationMethod`.
///
/// No number is required: `Number_below_cost` stops where the surface ceases to be smooth. No angle is, either: facets
/// of a coarse cylinder, of up to 32 degrees, are joined, and creases of less are not. With a number, merging goes on,
/// or stops before. Two faces that meet tangentially are kept apart where their curvatures across the joint differ by
/// more than about three quarters of the larger one: a fillet from what it blends, but not a fillet along a line from
/// the same fillet along a wide arc.
struct Smooth_faces
  : Segmentation_method<Region_growing, Smoothness_annotator, Lowest_cost_first<Smoothness_cost>,
                        Number_below_cost<Smoothness_cost>>
{
  /// The mean discontinuity above which two faces are not one.
  static constexpr double default_bound = 0.73;

  Smooth_faces()
    : Segmentation_method{Region_growing(), Smoothness_annotator(), Lowest_cost_first<Smoothness_cost>(),
                          Number_below_cost<Smoothness_cost>{default_bound}}
  {
    initializer.maximum_angle = annotator.flat_angle;
    initializer.feature_convexity = Feature_convexity::ALL;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SMOOTH_FACES_H
