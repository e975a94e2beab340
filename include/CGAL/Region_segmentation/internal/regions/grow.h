// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_GROW_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_GROW_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>
#include <CGAL/Region_segmentation/internal/surface/collect_adjacencies.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The connected components of the faces across edges that are neither features nor constrained. A
/// degenerate face joins the component across its longest edge that is not constrained.
/// `marks`: 1 for a feature, or 0
inline Partition grow(const Surface& surface, Edge_marks marks, const Execution& execution)
{
  for_each_index(execution, marks.size(),
                 [mark = marks.data(), flags = arrays_of(surface).flags.data()](std::size_t a) {
                   mark[a] |= (flags[a] & (Surface::barrier | Surface::CLOSED)) != 0;
                 });
  return label_components(surface, marks, 1, execution);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_GROW_H
