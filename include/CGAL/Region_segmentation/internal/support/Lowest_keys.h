// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LOWEST_KEYS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LOWEST_KEYS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/support/Float_key.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The lowest key that each element was offered; with `Parallel_tag` threads may offer keys
/// concurrently.
class Lowest_keys
{
public:
  /// Not initialized. `execution`: in parallel, threads may offer keys concurrently
  Lowest_keys(std::size_t size, const Execution& execution)
    : m_keys(size)
    , m_is_parallel(execution.is_parallel())
  {}

  void set(std::size_t i, Float_key key) { m_keys[i].store(key, std::memory_order_relaxed); }
  Float_key operator[](std::size_t i) const { return m_keys[i].load(std::memory_order_relaxed); }

  void offer(std::size_t i, Float_key key)
  {
    Float_key lowest = (*this)[i];
    if (m_is_parallel)
      while (key < lowest &&
             !m_keys[i].compare_exchange_weak(lowest, key, std::memory_order_relaxed)) {
      }
    else // without a branch, which would be mispredicted often
      set(i, (std::min)(lowest, key));
  }

private:
  Large_array<std::atomic<Float_key>> m_keys;
  bool m_is_parallel;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LOWEST_KEYS_H
