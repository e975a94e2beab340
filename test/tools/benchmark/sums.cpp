// SPDX-License-Identifier: GPL-3.0-or-later

#include "sums.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <functional>

namespace speed_benchmark {

namespace {

/// Four sums at a time: bound by memory, not by the latency of dependent additions.
double sum(const double* begin, const double* end, double start)
{
  double sums[4] = {start, 0, 0, 0};
  for (; end - begin >= 4; begin += 4)
    for (int i = 0; i < 4; ++i)
      sums[i] += begin[i];
  for (; begin != end; ++begin)
    sums[0] += *begin;
  return sums[0] + sums[1] + sums[2] + sums[3];
}

} // namespace

double Sums::on_one_thread() const
{
  return sum(m_numbers.data(), m_numbers.data() + m_numbers.size(), 0);
}

double Sums::in_parallel() const
{
  const double* first = m_numbers.data();
  using Range = tbb::blocked_range<const double*>;
  return tbb::parallel_reduce(
    Range(first, first + m_numbers.size(), 4096), 0.0,
    [](const Range& range, double start) { return sum(range.begin(), range.end(), start); },
    std::plus<double>());
}

} // namespace speed_benchmark
