// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_NO_SEGMENT_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_NO_SEGMENT_H

#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// The label of a face that belongs to no segment: -1, which is the highest value of an unsigned type. A map of `bool`
/// has no such label.
template <typename Label>
constexpr Label no_segment = Label(-1);

/// \ingroup PkgRegionSegmentationSegments
/// Whether a face with this label belongs to a segment.
template <typename Label>
constexpr bool is_segment(Label label)
{
  static_assert(std::is_integral<Label>::value, "the labels of segments are integral");
  return std::is_same<Label, bool>::value || label != no_segment<Label>;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_NO_SEGMENT_H
