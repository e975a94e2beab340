// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_EDGE_MARKS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_EDGE_MARKS_H

#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <cstdint>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// One byte per dual edge of a `Surface`, or per edge of a mesh, not zero if the edge is marked. A vector whose `resize()` does not
/// initialize elements.
using Edge_marks = Large_array<std::uint8_t>;

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_EDGE_MARKS_H
