// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TWO_STEP_GROW_REGIONS_H
#define CGAL_REGION_SEGMENTATION_TWO_STEP_GROW_REGIONS_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationStages
/// grows regions between the feature edges of a surface: the connected components of the faces
/// across edges that are neither feature edges nor constrained. Feature lines that end inside the
/// surface separate nothing, so they need not be removed before.
///
/// A degenerate face joins the region across its longest edge that is neither a border nor
/// constrained, unless this edge is marked as a feature edge; growing does not cross its other
/// edges.
///
/// \param surface the surface
/// \param is_feature by adjacency: 1 for a feature edge, or 0; see `detect_feature_edges()`
/// \param execution sequential or parallel; reports the progress of the stage that it is of
/// \returns the regions of the faces, numbered by the first face
/// \post every region is connected; two faces that share an edge which is not a feature edge, and
///       neither of which is degenerate, have the same region
///
/// Complexity: O(F). Deterministic. Parallel with a parallel `execution`.
///
/// Source: \cgalCite{YZWLL14}, section 3.2.
inline Partition grow_regions(const Surface& surface, std::vector<std::uint8_t> is_feature,
                              const Execution& execution = Execution())
{
  internal::for_each_index(execution, is_feature.size(), [&](std::size_t a) {
    is_feature[a] |= surface.has_flag(a, Surface::barrier | Surface::CLOSED);
  });
  return internal::label_components(surface, is_feature.data(), 1, execution);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TWO_STEP_GROW_REGIONS_H
