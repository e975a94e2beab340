// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_NO_SEGMENT_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_NO_SEGMENT_H

#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// The type of `no_segment`. It converts to labels of any integral type, and `label == no_segment`
/// and `label != no_segment` compare these with it.
struct No_segment
{
  template <typename Label, typename = std::enable_if_t<std::is_integral<Label>::value>>
  constexpr operator Label() const
  {
    return Label(-1);
  }
};

/// \ingroup PkgRegionSegmentationSegments
/// The label of a face that belongs to no segment: -1, which is the highest value of an unsigned
/// type. A map of `bool` has no such label.
inline constexpr No_segment no_segment{};

/// \ingroup PkgRegionSegmentationSegments
/// Whether a face with this label belongs to a segment.
template <typename Label>
constexpr bool is_segment(Label label)
{
  static_assert(std::is_integral<Label>::value, "the labels of segments are integral");
  return std::is_same<Label, bool>::value || label != Label(-1);
}

template <typename Label>
constexpr bool operator==(Label label, No_segment)
{
  return !is_segment(label);
}
template <typename Label>
constexpr bool operator!=(Label label, No_segment)
{
  return is_segment(label);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_NO_SEGMENT_H
