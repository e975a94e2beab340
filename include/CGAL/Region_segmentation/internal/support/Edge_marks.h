// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_EDGE_MARKS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_EDGE_MARKS_H

#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <cstdint>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// One byte a dual edge of a `Flat_mesh`; not zero where the edge is marked. A vector that does not initialize what
/// it is resized to.
using Edge_marks = Large_array<std::uint8_t>;

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_EDGE_MARKS_H
