// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_THREAD_SANITIZER_TBB_PARALLEL_FOR_H
#define CGAL_REGION_SEGMENTATION_TEST_THREAD_SANITIZER_TBB_PARALLEL_FOR_H

// In place of TBB, whose synchronization the thread sanitizer does not see unless TBB itself is
// compiled with it: every loop by four threads, which take indices one by one. Nothing else orders
// them, so that any race of the loops is seen.

#include <array>
#include <atomic>
#include <exception>
#include <thread>

namespace tbb {

template <typename Index, typename F>
void parallel_for(Index first, Index last, const F& f)
{
  std::atomic<Index> next(first);
  std::array<std::exception_ptr, 4> errors;
  std::array<std::thread, 4> threads;
  for (std::size_t t = 0; t < threads.size(); ++t)
    threads[t] = std::thread([&, t] {
      try {
        for (Index i = next.fetch_add(1, std::memory_order_relaxed); i < last;
             i = next.fetch_add(1, std::memory_order_relaxed))
          f(i);
      } catch (...) {
        errors[t] = std::current_exception();
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  for (const std::exception_ptr& error : errors)
    if (error)
      std::rethrow_exception(error);
}

} // namespace tbb

#endif // CGAL_REGION_SEGMENTATION_TEST_THREAD_SANITIZER_TBB_PARALLEL_FOR_H
