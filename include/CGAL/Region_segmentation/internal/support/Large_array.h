// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LARGE_ARRAY_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LARGE_ARRAY_H

#include <boost/core/noinit_adaptor.hpp>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Asks for huge pages for a block of memory, if it is large, on Linux.
inline void ask_for_large_pages(void* block, std::size_t size)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t large = std::size_t(1) << 22, multiple_of_pages = std::size_t(1) << 16;
  if (size >= large && std::align(multiple_of_pages, large / 2, block, size))
    madvise(block, size, MADV_HUGEPAGE); // only a hint; failure is harmless
#else
  static_cast<void>(block);
  static_cast<void>(size);
#endif
}

/// Asks for huge pages for large blocks, on Linux: with pages of 4 kB the first use of new memory
/// takes a quarter of the time of `two-step` (`doc/performance.md`), and random accesses miss the
/// TLB.
template <typename T>
struct Large_page_allocator
{
  using value_type = T;

  Large_page_allocator() = default;
  template <typename U>
  Large_page_allocator(const Large_page_allocator<U>&)
  {}

  T* allocate(std::size_t n)
  {
    void* const block = new_block(n * sizeof(T));
    ask_for_large_pages(block, n * sizeof(T));
    return static_cast<T*>(block);
  }

  void deallocate(T* block, std::size_t)
  {
    if constexpr (is_over_aligned)
      ::operator delete(block, std::align_val_t(alignof(T)));
    else
      ::operator delete(block);
  }

  friend bool operator==(const Large_page_allocator&, const Large_page_allocator&) { return true; }
  friend bool operator!=(const Large_page_allocator&, const Large_page_allocator&) { return false; }

private:
  static constexpr bool is_over_aligned = alignof(T) > __STDCPP_DEFAULT_NEW_ALIGNMENT__;

  static void* new_block(std::size_t bytes)
  {
    if constexpr (is_over_aligned)
      return ::operator new(bytes, std::align_val_t(alignof(T)));
    else
      return ::operator new(bytes);
  }
};

/// A vector with an element per face, edge or section: in large pages, and `resize()` does not
/// initialize trivial elements, so that memory is first touched by the thread that fills it.
template <typename T>
using Large_array = std::vector<T, boost::noinit_adaptor<Large_page_allocator<T>>>;

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LARGE_ARRAY_H
