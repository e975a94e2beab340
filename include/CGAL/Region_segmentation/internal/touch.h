// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_TOUCH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_TOUCH_H

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Reads a byte, so that its line is in the cache later: in a loop of reads that do not depend on each other, memory
/// is waited for once, not every time. (Prefetch instructions did nothing where pages had to be looked up first.)
inline void touch(const void* address)
{
  static_cast<void>(*static_cast<const volatile char*>(address));
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_TOUCH_H
