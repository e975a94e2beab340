// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FOR_EACH_IN_PART_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FOR_EACH_IN_PART_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(part, element)` for all elements of a partition; those of a part in order, by one
/// thread, so that sums are the same in parallel. Each thread first sorts a range of the elements
/// by ranges of parts, then has one of these.
///
/// \tparam Parts a `Partition` or a `Composed_partition`
template <typename Parts, typename F>
void for_each_in_part(const Execution& execution, const Parts& parts, const F& f)
{
  const std::size_t ranges = execution.number_of_threads();
  if (ranges == 1) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      f(parts[i], i);
    return;
  }
  using Index = Partition::Index;
  const std::size_t size = number_of_blocks(parts.size(), ranges),
                    number = number_of_blocks(parts.number_of_parts(), ranges); // in a range
  std::vector<Grouped_items<Index>> elements(ranges);
  execution.for_each(0, ranges, [&](std::size_t range) {
    const std::size_t end = (std::min)((range + 1) * size, parts.size());
    elements[range] = Grouped_items<Index>(ranges, [&](const auto& add) {
      for (std::size_t i = range * size; i < end; ++i)
        add(parts[i] / number, Index(i));
    });
  });
  execution.for_each(0, ranges, [&](std::size_t range_of_parts) {
    for (const Grouped_items<Index>& of_range : elements)
      for (const Index i : of_range[range_of_parts])
        f(parts[i], i);
  });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FOR_EACH_IN_PART_H
