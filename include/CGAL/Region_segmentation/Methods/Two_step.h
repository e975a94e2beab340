// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_TWO_STEP_H
#define CGAL_REGION_SEGMENTATION_METHODS_TWO_STEP_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Graph/geometry_data.h>
#include <CGAL/Region_segmentation/Hierarchy.h>
#include <CGAL/Region_segmentation/Methods/Least_compact_region_first.h>
#include <CGAL/Region_segmentation/Methods/Region_growing.h>
#include <CGAL/Region_segmentation/Methods/Smallest_region_first.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/concepts/Method_calls.h>
#include <CGAL/Region_segmentation/internal/graph/build_graph.h>
#include <CGAL/Region_segmentation/internal/support/check_constants.h>
#include <CGAL/Region_segmentation/requested_regions.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationMethods
/// The method of the paper: `Region_growing` between feature edges, merged by
/// `Smallest_region_first` while there are more than `factor` times the wanted number of regions,
/// then by `Least_compact_region_first`. A model of `SegmentationMethod`.
///
/// It requires the number of segments, on which the order of merges depends.
///
/// Source: \cgalCite{YZWLL14}.
struct Two_step
{
  Region_growing growing;
  double beta = 0.1;  ///< the weight of a section's length against its flatness, in [0, 1]
  double gamma = 0.6; ///< the weight of a region's planarity against its area, in [0, 1]
  double factor = 2;  ///< the number of regions after step one, as a multiple of the wanted number
                      ///< of segments, at least 1

  struct Prepared
  {
    Partition regions;
  };

  Prepared prepare(const Surface& surface, const Execution& execution = Execution()) const
  {
    growing.check_constants();
    internal::check_constant("Two_step: beta", beta, 0, 1);
    internal::check_constant("Two_step: gamma", gamma, 0, 1);
    internal::check_constant("Two_step: factor", factor, 1);
    return {growing(surface, execution.stage("regions"))};
  }

  Segmentation merge(const Surface& surface, const Prepared& prepared, const Request& request,
                     const Execution& execution = Execution()) const
  {
    const std::size_t number = request.number_of_segments;
    CGAL_precondition_msg(number >= 1, "Two_step needs the number of segments");
    Requested_regions requested = requested_regions(surface, prepared.regions, request.seeds);
    auto graph = internal::build_graph<Region_geometry, Section_geometry>(
      surface, requested.regions, execution.stage("graph"));
    const double after_step_one = (std::min)(factor * double(number),
                                             double(graph.number_of_regions()));
    const Policy_phases<Smallest_region_first, Least_compact_region_first> steps{
      {Smallest_region_first(beta), std::size_t(after_step_one)},
      {Least_compact_region_first(beta, gamma), number}};
    Merge_tree tree = merge_requested_regions(surface, requested, graph, steps, number,
                                              execution.stage("merging"));
    return {std::move(requested.regions), std::move(tree), number};
  }
};

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template struct internal::Method_calls<Two_step>;
#endif

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_TWO_STEP_H
