// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPPORT_LARGE_ARRAY_H
#define CGAL_REGION_SEGMENTATION_SUPPORT_LARGE_ARRAY_H

#include <boost/core/noinit_adaptor.hpp>

#include <cstddef>
#include <memory>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// An allocator that asks Linux for huge pages for blocks of at least 4 MB: with pages of 4 kB the
/// first use of new memory takes a quarter of the time of `Two_step` (`doc/performance.md`).
template <typename T>
struct Large_page_allocator : std::allocator<T>
{
  template <typename U>
  struct rebind
  {
    using other = Large_page_allocator<U>;
  };

  Large_page_allocator() = default;
  template <typename U>
  Large_page_allocator(const Large_page_allocator<U>&)
  {}

  T* allocate(std::size_t n)
  {
    T* const elements = std::allocator<T>::allocate(n);
#ifdef __linux__
    void* block = elements;
    std::size_t size = n * sizeof(T);
    if (size >= (std::size_t(1) << 22) && std::align(1 << 16, size / 2, block, size))
      madvise(block, size, MADV_HUGEPAGE); // a hint, which may fail
#endif
    return elements;
  }
};

} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// A vector with an element per face, edge or section. `resize()` does not initialize trivial
/// elements, so that memory is first touched by the thread that fills it.
template <typename T>
using Large_array = std::vector<T, boost::noinit_adaptor<internal::Large_page_allocator<T>>>;

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPPORT_LARGE_ARRAY_H
