// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_CHECK_OUTPUT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_CHECK_OUTPUT_H

#include <CGAL/Region_segmentation/internal/support/satisfies.h>

#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename OutputIterator, typename Value>
using Takes_value = decltype(*std::declval<OutputIterator&>()++ = std::declval<Value>());

/// For functions that output a value for each segment or border, of a type with the label type of
/// the map as its argument.
template <typename OutputIterator, typename Value>
constexpr bool check_output_of_labels()
{
  static_assert(satisfies<Takes_value, OutputIterator, Value>,
                "the output iterator does not take what this function gives: "
                "Segment_piece<SegmentMesh, FaceGraph, Label>, Segment_border<FaceGraph, Label> or "
                "Segment_description<Label, Kernel>, whose Label is the value type of the map of "
                "segments");
  return true;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_CHECK_OUTPUT_H
