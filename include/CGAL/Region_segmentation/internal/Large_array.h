// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_LARGE_ARRAY_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_LARGE_ARRAY_H

#include <boost/core/noinit_adaptor.hpp>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstddef>
#include <new>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Allocates large blocks at the border of a huge page, and on Linux asks for huge pages: with pages of 4 kB
/// their first use takes up to a third of the time of reading a mesh, and jumping about in them misses the
/// table of pages almost every time.
template <typename T>
struct Large_page_allocator
{
  using value_type = T;

  Large_page_allocator() = default;
  template <typename U>
  Large_page_allocator(const Large_page_allocator<U>&) {}

  T* allocate(std::size_t n)
  {
    if (!is_large(n))
      return static_cast<T*>(::operator new(n * sizeof(T)));
    void* memory = ::operator new(n * sizeof(T), std::align_val_t(page_size));
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    madvise(memory, n * sizeof(T), MADV_HUGEPAGE); // a wish: nothing is lost where it is not granted
#endif
    return static_cast<T*>(memory);
  }

  void deallocate(T* memory, std::size_t n)
  {
    if (is_large(n))
      ::operator delete(memory, std::align_val_t(page_size));
    else
      ::operator delete(memory);
  }

  friend bool operator==(const Large_page_allocator&, const Large_page_allocator&) { return true; }
  friend bool operator!=(const Large_page_allocator&, const Large_page_allocator&) { return false; }

private:
  static constexpr std::size_t page_size = std::size_t(1) << 21;
  static bool is_large(std::size_t n) { return n >= 2 * page_size / sizeof(T); }
};

/// A vector for elements by the face, edge or section: in large pages, and `resize()` leaves trivial elements
/// as they are, so that memory is touched first by who fills it.
template <typename T>
using Large_array = std::vector<T, boost::noinit_adaptor<Large_page_allocator<T>>>;

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_LARGE_ARRAY_H
