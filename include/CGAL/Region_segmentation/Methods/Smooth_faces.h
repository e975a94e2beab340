// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SMOOTH_FACES_H
#define CGAL_REGION_SEGMENTATION_METHODS_SMOOTH_FACES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Hierarchy.h>
#include <CGAL/Region_segmentation/Methods/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Methods/Number_below_cost.h>
#include <CGAL/Region_segmentation/Methods/Region_growing.h>
#include <CGAL/Region_segmentation/Methods/Smoothness_annotator.h>
#include <CGAL/Region_segmentation/Methods/Smoothness_cost.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/graph/build_graph.h>
#include <CGAL/Region_segmentation/merge_requested_regions.h>
#include <CGAL/Region_segmentation/requested_regions.h>

#include <cstddef>
#include <utility>
#include <vector>

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
{
  Region_growing growing;
  Smoothness_annotator annotator;
  Smoothness_cost cost;
  Number_below_cost chooser = {0.73}; ///< the mean discontinuity above which two faces are not one

  Smooth_faces()
  {
    growing.maximum_angle = annotator.flat_angle;
    growing.feature_convexity = Feature_convexity::ALL;
  }

  struct Prepared
  {
    Partition regions; ///< grown without constraints
    std::vector<double> discontinuities;
  };

  Prepared prepare(const Surface& surface, const Execution& execution = Execution()) const
  {
    return {growing(surface, Constraints(), execution.stage("regions")),
            annotator.discontinuities(surface, execution.stage("graph"))};
  }

  Hierarchy merge(const Surface& surface, const Prepared& prepared, const Request& request,
                  const Execution& execution = Execution()) const
  {
    Requested_regions requested = requested_regions(surface, prepared.regions, request);
    auto graph = internal::build_graph<Smoothness_region_data, Smoothness_section_data>(
      surface, requested.regions, request.constraints, execution.stage("graph"));
    annotator(graph, surface, requested.regions, prepared.discontinuities);
    Merge_tree tree = merge_requested_regions(surface, requested, graph, Lowest_cost_first<Smoothness_cost>(cost), 1,
                                                execution.stage("merging"));
    const std::size_t number = request.number_of_segments > 0 ? request.number_of_segments : chooser(tree, surface);
    return Hierarchy(std::move(requested.regions), std::move(tree), number);
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SMOOTH_FACES_H
