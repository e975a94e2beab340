// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_REGION_GROWING_H
#define CGAL_REGION_SEGMENTATION_METHODS_REGION_GROWING_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Feature_convexity.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/internal/regions/grow.h>
#include <CGAL/Region_segmentation/internal/regions/mark_feature_edges.h>

#include <CGAL/assertions.h>

#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationInitializers
/// The regions of the paper: the connected components of the faces across edges that are not
/// feature edges.
///
/// The feature edges are those that `detect_feature_edges()` marks. A degenerate face joins the
/// region across its longest interior edge.
///
/// Complexity: O(F). Deterministic. Parallel with `Parallel_tag`, with bitwise equal results.
///
/// Source: \cgalCite{YZWLL14}, sections 3.1 and 3.2.
struct Region_growing
{
  /// The deviation above which an edge is a feature edge, in degrees, in [0, 180].
  double maximum_angle = default_maximum_angle;
  /// Which edges can be feature edges.
  Feature_convexity feature_convexity = Feature_convexity::CONCAVE;

  /// The regions of the faces.
  Partition operator()(const Surface& surface, const Execution& execution = Execution()) const
  {
    CGAL_precondition_msg(maximum_angle >= 0 && maximum_angle <= 180,
                          "maximum_angle is in [0, 180] degrees");
    auto is_feature = internal::mark_feature_edges(surface, maximum_angle, feature_convexity,
                                                   execution.step(0, 0.5));
    return internal::grow(surface, std::move(is_feature), execution.step(0.5, 1));
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_REGION_GROWING_H
