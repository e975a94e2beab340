// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SORTED_INDICES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SORTED_INDICES_H

#include <CGAL/Region_segmentation/internal/support/Function_ref.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// 0 .. `size` - 1 in the order of `less(i, j)`: one sort, compiled once, for all that is seldom
/// sorted.
inline std::vector<std::uint32_t>
sorted_indices(std::size_t size, Function_ref<bool(std::uint32_t, std::uint32_t)> less)
{
  std::vector<std::uint32_t> result(size);
  std::iota(result.begin(), result.end(), std::uint32_t(0));
  std::sort(result.begin(), result.end(), less);
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SORTED_INDICES_H
