// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NUMBER_SEGMENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NUMBER_SEGMENTS_H

#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/internal/support/Key_numbering.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The segment of each face; the highest number for a face without one. Segments are numbered by
/// their first faces; their labels are added to `labels`.
template <typename FaceGraph, typename SegmentMap, typename Label>
std::vector<std::uint32_t> number_segments(const FaceGraph& mesh, const SegmentMap& segment_map,
                                           std::vector<Label>& labels)
{
  std::vector<std::uint32_t> result;
  Key_numbering number(2 * num_faces(mesh) + 1024);
  for (auto f : faces(mesh)) {
    const Label label = get(segment_map, f);
    result.push_back(is_segment(label) ? number(static_cast<std::uint64_t>(label))
                                       : (std::numeric_limits<std::uint32_t>::max)());
    if (number.size() > labels.size())
      labels.push_back(label);
  }
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NUMBER_SEGMENTS_H
