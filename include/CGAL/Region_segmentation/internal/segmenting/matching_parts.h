// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_MATCHING_PARTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_MATCHING_PARTS_H

#include <CGAL/Region_segmentation/Partition.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// For each part of `after` the part of `before` with the same elements, or the highest number if there is none.
/// \pre both are partitions of the same elements
inline std::vector<Partition::Index> matching_parts(const Partition& before, const Partition& after)
{
  using Index = Partition::Index;
  constexpr Index none = (std::numeric_limits<Index>::max)(), unknown = none - 1;
  std::vector<Index> match(after.number_of_parts(), unknown);
  std::vector<std::size_t> size_before(before.number_of_parts()), size_after(after.number_of_parts());
  for (std::size_t i = 0; i < after.size(); ++i) {
    Index& m = match[after[i]];
    m = m == unknown || m == before[i] ? before[i] : none;
    ++size_before[before[i]];
    ++size_after[after[i]];
  }
  for (std::size_t part = 0; part < match.size(); ++part)
    if (match[part] < unknown && size_before[match[part]] != size_after[part])
      match[part] = none;
  return match;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_MATCHING_PARTS_H
