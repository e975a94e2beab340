// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FOR_EACH_IN_PART_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FOR_EACH_IN_PART_H

#include <CGAL/Region_segmentation/Execution.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(part, element)` for all elements of a partition; those of a part in order, by one
/// thread, so that sums are the same in parallel. Each thread has some of the parts, and looks at
/// all elements from the first on that may be in them.
///
/// \tparam Parts a `Partition` or a `Composed_partition`
template <typename Parts, typename F>
void for_each_in_part(const Execution& execution, const Parts& parts, const F& f)
{
  const std::size_t ranges = execution.number_of_threads();
  const std::size_t size = number_of_blocks(parts.number_of_parts(), ranges);
  execution.for_each(0, ranges, [&](std::size_t range) {
    const std::size_t first = range * size;
    for (std::size_t i = first; i < parts.size(); ++i) // no part is above its first element
      if (const std::size_t part = parts[i]; part - first < size)
        f(part, i);
  });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FOR_EACH_IN_PART_H
