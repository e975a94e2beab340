// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SECONDS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SECONDS_H

#include <ctime>

namespace speed_benchmark {

/// One thread is timed by the processor time of the process, so others on the machine disturb
/// little; several threads, and what they are compared with, by the time that goes by.
enum class Clock { PROCESSOR, WALL };

inline double seconds(Clock clock)
{
  timespec now;
  clock_gettime(clock == Clock::WALL ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// How long a call takes.
template <typename Function>
double seconds_of(Clock clock, const Function& function)
{
  const double start = seconds(clock);
  function();
  return seconds(clock) - start;
}

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SECONDS_H
