// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_THREAD_SANITIZER_TBB_TASK_ARENA_H
#define CGAL_REGION_SEGMENTATION_TEST_THREAD_SANITIZER_TBB_TASK_ARENA_H

namespace tbb {
namespace this_task_arena {

/// The number of threads of `parallel_for()`.
inline int max_concurrency()
{
  return 4;
}

} // namespace this_task_arena
} // namespace tbb

#endif // CGAL_REGION_SEGMENTATION_TEST_THREAD_SANITIZER_TBB_TASK_ARENA_H
