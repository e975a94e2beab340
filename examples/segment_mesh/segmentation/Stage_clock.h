// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_STAGE_CLOCK_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_STAGE_CLOCK_H

#include "segmentation/run_segmentation.h"

#include <chrono>
#include <string>
#include <vector>

namespace segment_mesh {

/// A `SegmentationVisitor` that times the stages, and hands on what it hears.
class Stage_clock
{
public:
  explicit Stage_clock(const Progress_listener& listener)
    : m_listener(listener)
  {}

  bool go_further(const char* stage, double fraction)
  {
    if (m_starts.empty() || m_starts.back().stage != stage)
      m_starts.push_back({stage, Clock::now()});
    return !m_listener || m_listener(stage, fraction);
  }

  /// From the first word of the first stage to now.
  double seconds() const
  {
    return m_starts.empty() ? 0 : between(m_starts.front().time, Clock::now());
  }

  /// A stage lasts until the next one starts, the last one until now.
  std::vector<Stage_time> stages() const
  {
    std::vector<Stage_time> result;
    for (std::size_t i = 0; i < m_starts.size(); ++i) {
      const Clock::time_point end = i + 1 < m_starts.size() ? m_starts[i + 1].time : Clock::now();
      result.push_back({m_starts[i].stage, between(m_starts[i].time, end)});
    }
    return result;
  }

private:
  using Clock = std::chrono::steady_clock;

  struct Start
  {
    std::string stage;
    Clock::time_point time;
  };

  static double between(Clock::time_point from, Clock::time_point to)
  {
    return std::chrono::duration<double>(to - from).count();
  }

  const Progress_listener& m_listener;
  std::vector<Start> m_starts;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_STAGE_CLOCK_H
