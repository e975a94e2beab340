// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_STAGE_CLOCK_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_STAGE_CLOCK_H

#include "seconds.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <numeric>

namespace speed_benchmark {

/// Reading is what makes the flat mesh and its patches; `GRAPH` includes the annotation; the last
/// one ends when the labels are written.
enum class Stage { READING, REGIONS, GRAPH, MERGING, BORDERS };
constexpr std::size_t number_of_stages = 5;

struct Stage_seconds
{
  std::array<double, number_of_stages> of_stage = {};
  std::size_t number_of_regions = 0;

  double until(Stage last) const
  {
    return std::accumulate(of_stage.begin(), of_stage.begin() + std::ptrdiff_t(last) + 1, 0.0);
  }
  double whole() const { return until(Stage::BORDERS); }
};

/// A `SegmentationVisitor` that times the stages of one call of `segment()`. A stage lasts until
/// the next begins. It ends the call after the last stage that is wanted.
class Stage_clock
{
public:
  explicit Stage_clock(Clock clock, Stage last = Stage::BORDERS)
    : m_clock(clock)
    , m_last(last)
    , m_start(seconds(clock))
  {}

  bool on_progress(const char* name, double)
  {
    const Stage stage = stage_of(name);
    if (stage > m_stage)
      enter(stage);
    return stage <= m_last;
  }

  void set_number_of_regions(std::size_t number) { m_seconds.number_of_regions = number; }

  Stage_seconds stop()
  {
    if (m_stage <= m_last)
      enter(m_stage);
    return m_seconds;
  }

private:
  void enter(Stage stage)
  {
    const double now = seconds(m_clock);
    m_seconds.of_stage[std::size_t(m_stage)] += now - m_start;
    m_start = now;
    m_stage = stage;
  }

  static Stage stage_of(const char* name)
  {
    constexpr const char* names[number_of_stages] = {"reading", "regions", "graph", "merging",
                                                     "borders"};
    for (std::size_t i = 0; i < number_of_stages; ++i)
      if (std::strcmp(name, names[i]) == 0)
        return Stage(i);
    return Stage::BORDERS;
  }

  Clock m_clock;
  Stage m_last, m_stage = Stage::READING;
  double m_start;
  Stage_seconds m_seconds;
};

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_STAGE_CLOCK_H
