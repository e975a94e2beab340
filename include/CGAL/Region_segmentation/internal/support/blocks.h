// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_BLOCKS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_BLOCKS_H

#include <CGAL/Region_segmentation/Execution.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>

// Work on all elements is divided into blocks of a fixed size, independent of the number of threads: the result of a
// block, and so every result, is the same sequentially and in parallel.

namespace CGAL {
namespace Region_segmentation {
namespace internal {

inline constexpr std::size_t block_size = 1 << 12;

/// Consecutive blocks for one thread, where elements between two ranges cost more.
inline constexpr std::size_t blocks_in_range = 16;

inline std::size_t number_of_blocks(std::size_t number_of_elements, std::size_t size = block_size)
{
  return (number_of_elements + size - 1) / size;
}

/// Calls `f(block)` for the blocks `first` .. `last - 1`, in order or in parallel.
template <typename ConcurrencyTag, typename F>
void for_each_block_of(std::size_t first, std::size_t last, const F& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (Execution<ConcurrencyTag>::is_parallel) {
    tbb::parallel_for(first, last, f);
    return;
  }
#else
  static_assert(!Execution<ConcurrencyTag>::is_parallel, "Parallel_tag needs TBB: link CGAL::TBB_support");
#endif
  for (std::size_t block = first; block < last; ++block)
    f(block);
}

/// Of which results must not depend.
template <typename ConcurrencyTag>
std::size_t number_of_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (Execution<ConcurrencyTag>::is_parallel)
    return std::size_t(tbb::this_task_arena::max_concurrency());
#endif
  return 1;
}

/// Calls `f(block, begin, end)` for every block of the elements 0 .. n-1, in order or in parallel, and reports progress
/// in between. Expensive elements use blocks of another size.
///
/// Threads wait for each other at a report. (With one range of blocks for each report, a visitor would undo the gain of two
/// threads.)
template <typename ConcurrencyTag, typename F>
void for_each_block(const Execution<ConcurrencyTag>& execution, std::size_t number_of_elements, const F& f,
                    std::size_t size = block_size)
{
  const std::size_t number = number_of_blocks(number_of_elements, size);
  const auto work_on = [&](std::size_t block) {
    const std::size_t begin = block * size;
    f(block, begin, (std::min)(begin + size, number_of_elements));
  };
  constexpr std::size_t number_of_reports = 50;
  constexpr std::size_t blocks_of_a_thread = Execution<ConcurrencyTag>::is_parallel ? 4 : 1;
  const std::size_t between_reports =
    execution.has_visitor()
      ? (std::max)(number / number_of_reports + 1, blocks_of_a_thread * number_of_threads<ConcurrencyTag>())
      : number;
  for (std::size_t first = 0; first < number;) {
    const std::size_t last = (std::min)(first + between_reports, number);
    for_each_block_of<ConcurrencyTag>(first, last, work_on);
    execution.report(double(last) / double(number));
    first = last;
  }
}

/// Calls `f(i)` for 0 .. n-1, in order or in parallel.
template <typename ConcurrencyTag, typename F>
void for_each_index(std::size_t n, const F& f)
{
  for_each_block(Execution<ConcurrencyTag>(), n, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      f(i);
  });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_BLOCKS_H
