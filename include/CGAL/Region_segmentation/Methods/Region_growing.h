// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_REGION_GROWING_H
#define CGAL_REGION_SEGMENTATION_METHODS_REGION_GROWING_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Feature_convexity.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/regions/mark_feature_edges.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationInitializers
/// The regions of the paper: the connected components of the faces across edges that are not feature edges. A model of
/// `RegionInitializer`.
///
/// The feature edges are those that `detect_feature_edges()` marks. A degenerate face joins the region across its
/// longest interior edge.
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

  template <typename ConcurrencyTag = CGAL::Sequential_tag>
  Partition operator()(const Flat_mesh& mesh,
                       const Execution<ConcurrencyTag>& execution = Execution<ConcurrencyTag>()) const
  {
    CGAL_precondition_msg(maximum_angle >= 0 && maximum_angle <= 180, "maximum_angle is in [0, 180] degrees");
    const internal::Feature_criterion criterion(maximum_angle, feature_convexity);
    const auto is_feature = internal::mark_feature_edges(mesh, criterion, execution.step(0, 0.5));
    const auto joins = [&](std::size_t e) { return !is_feature[e] && !mesh.has_flag(e, Flat_mesh::CLOSED); };
    return internal::label_components(mesh, joins, execution.step(0.5, 1));
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_REGION_GROWING_H
