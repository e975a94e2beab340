// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_THREAD_SANITIZER_TBB_GLOBAL_CONTROL_H
#define CGAL_REGION_SEGMENTATION_TEST_THREAD_SANITIZER_TBB_GLOBAL_CONTROL_H

#include <cstddef>

namespace tbb {

/// The number of threads is always that of `parallel_for()`.
struct global_control
{
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t) {}
};

} // namespace tbb

#endif // CGAL_REGION_SEGMENTATION_TEST_THREAD_SANITIZER_TBB_GLOBAL_CONTROL_H
