// SPDX-License-Identifier: GPL-3.0-or-later

// Large blocks of memory in huge pages, on Linux: of the time from a file of 10 million faces to a `Surface_mesh` the first
// use of new memory takes more than half in pages of 4 kB (doc/performance.md). That mesh has vectors of its own, so it is
// `operator new` that asks for them.

#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <cstddef>
#include <cstdlib>
#include <new>

void* operator new(std::size_t size)
{
  void* block = nullptr;
  while ((block = std::malloc(size == 0 ? 1 : size)) == nullptr) {
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr)
      throw std::bad_alloc();
    handler();
  }
  CGAL::Region_segmentation::internal::ask_for_large_pages(block, size);
  return block;
}

void operator delete(void* block) noexcept
{
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept
{
  std::free(block);
}
