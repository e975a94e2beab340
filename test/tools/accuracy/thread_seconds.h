// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_THREAD_SECONDS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_THREAD_SECONDS_H

#include <ctime>

namespace princeton_benchmark {

/// CPU time of the calling thread: models run side by side, and other programs do not count.
inline double thread_seconds()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_THREAD_SECONDS_H
