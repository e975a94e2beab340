// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TWO_STEP_TWO_STEP_H
#define CGAL_REGION_SEGMENTATION_TWO_STEP_TWO_STEP_H

#include <CGAL/Region_segmentation/Graph/Hierarchy.h>
#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/internal/run_method.h>
#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/Two_step/Least_compact_region_first.h>
#include <CGAL/Region_segmentation/Two_step/Smallest_region_first.h>
#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>
#include <CGAL/Region_segmentation/Two_step/grow_regions.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationMethods
/// The method of the paper: regions are grown between feature edges, then merged by
/// `Smallest_region_first` while there are more than `factor` times the wanted number k of regions,
/// then by `Least_compact_region_first` while there are more than k. A model of
/// `SegmentationMethod`.
///
/// It requires the number of segments, on which the order of merges depends.
///
/// Source: \cgalCite{YZWLL14}, section 3.
struct Two_step
{
  static constexpr bool fills_voids = true; ///< see `SegmentationMethod`

  /// The deviation above which an edge is a feature edge, in degrees, in [0, 180].
  double maximum_angle = default_maximum_angle;
  /// Which edges can be feature edges.
  Feature_convexity feature_convexity = Feature_convexity::CONCAVE;
  double beta = 0.1;  ///< the weight of a section's length against its flatness, in [0, 1]
  double gamma = 0.6; ///< the weight of a region's planarity against its area, in [0, 1]
  double factor = 2;  ///< the number of regions after step one, as a multiple of the wanted number
                      ///< of segments, at least 1

  struct Prepared
  {
    Partition regions;
  };

  /// Sections 3.1 and 3.2 of the paper: feature edges, and the regions grown between them.
  Prepared prepare(const Surface& surface, std::size_t /* number_of_segments */ = 0,
                   const Execution& execution = Execution()) const
  {
    internal::check_constant("Two_step: maximum_angle", maximum_angle, 0, 180);
    internal::check_constant("Two_step: beta", beta, 0, 1);
    internal::check_constant("Two_step: gamma", gamma, 0, 1);
    internal::check_constant("Two_step: factor", factor, 1);
    const Execution stage = execution.stage("regions");
    const std::vector<std::uint8_t> is_feature = detect_feature_edges(
      surface, maximum_angle, feature_convexity, stage.step(0, 0.5));
    return {grow_regions(surface, is_feature, stage.step(0.5, 1))};
  }

  /// Section 3.3 of the paper: the regions C_i and the sections between them are merged in two
  /// steps.
  Segmentation merge(const Surface& surface, const Prepared& prepared, const Request& request,
                     const Execution& execution = Execution()) const
  {
    const std::size_t k = request.number_of_segments;
    CGAL_precondition_msg(k >= 1, "Two_step needs the number of segments");
    Requested_regions requested = requested_regions(surface, prepared.regions, request.seeds);
    auto graph = build_region_adjacency_graph(surface, requested.regions, execution.stage("graph"));
    const double after_step_one = (std::min)(factor * double(k), double(graph.number_of_regions()));
    const Policy_phases<Smallest_region_first, Least_compact_region_first> steps{
      {Smallest_region_first(beta), std::size_t(after_step_one)},
      {Least_compact_region_first(beta, gamma), k}};
    Merge_tree tree = merge_requested_regions(surface, requested, graph, steps, k,
                                              execution.stage("merging"));
    return {std::move(requested.regions), std::move(tree), k};
  }
};

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template struct internal::Method_calls<Two_step>;
#endif

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TWO_STEP_TWO_STEP_H
