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
#include <CGAL/Region_segmentation/internal/support/check_constants.h>

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

  /// \throws Invalid_method if a constant is not in its range
  void check_constants() const
  {
    internal::check_constant("Region_growing: maximum_angle", maximum_angle, 0, 180);
  }

  /// The regions of the faces.
  Partition operator()(const Surface& surface, const Execution& execution = Execution()) const
  {
    auto is_feature = internal::mark_feature_edges(surface, maximum_angle, feature_convexity,
                                                   execution.step(0, 0.5));
    return internal::grow(surface, std::move(is_feature), execution.step(0.5, 1));
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_REGION_GROWING_H
