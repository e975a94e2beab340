// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_BLOCKS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_BLOCKS_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>

// Work on all elements is cut into blocks of a fixed number of them, whatever the number of threads: what is
// computed for a block, and so every result, is the same in sequence and in parallel.

namespace CGAL {
namespace Region_segmentation {
namespace internal {

constexpr std::size_t block_size = 1 << 12;

/// Blocks in a row that one thread works on, where what is between two ranges costs more.
constexpr std::size_t blocks_in_range = 16;

inline std::size_t number_of_blocks(std::size_t number_of_elements, std::size_t size = block_size)
{
  return (number_of_elements + size - 1) / size;
}

template <typename ConcurrencyTag>
constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value;

/// Calls `f(block, begin, end)` for every block of the elements 0 .. n-1, in order or in parallel. Elements that
/// take long go in blocks of another size.
template <typename ConcurrencyTag, typename F>
void for_each_block(std::size_t number_of_elements, const F& f, std::size_t size = block_size)
{
  const std::size_t number = number_of_blocks(number_of_elements, size);
  const auto work_on = [&](std::size_t block) {
    const std::size_t begin = block * size;
    f(block, begin, (std::min)(begin + size, number_of_elements));
  };
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel<ConcurrencyTag>) {
    tbb::parallel_for(std::size_t(0), number, work_on);
    return;
  }
#else
  static_assert(!is_parallel<ConcurrencyTag>, "Parallel_tag needs TBB: link CGAL::TBB_support");
#endif
  for (std::size_t block = 0; block < number; ++block)
    work_on(block);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_BLOCKS_H
