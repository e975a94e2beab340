// SPDX-License-Identifier: GPL-3.0-or-later

#include "segment_with.h"

#include <CGAL/Region_segmentation/best.h>
#include <CGAL/Region_segmentation/segment.h>
#include <CGAL/Region_segmentation/two_step.h>

#include <chrono>
#include <functional>
#include <string>

namespace princeton_benchmark {

namespace RS = CGAL::Region_segmentation;

namespace {

/// A `SegmentationVisitor` that adds up the time of the stages. A stage lasts until the next
/// begins.
class Stage_timer
{
public:
  bool go_further(const std::string& stage, double)
  {
    if (stage != m_stage) {
      finish();
      m_stage = stage;
    }
    return true;
  }

  Stage_seconds finish()
  {
    const Clock::time_point now = Clock::now();
    if (!m_stage.empty())
      place() += std::chrono::duration<double>(now - m_start).count();
    m_start = now;
    return m_seconds;
  }

private:
  using Clock = std::chrono::steady_clock;

  double& place()
  {
    if (m_stage == "merging")
      return m_seconds.merging;
    return m_stage == "regions" ? m_seconds.growing : m_seconds.features;
  }

  std::string m_stage;
  Clock::time_point m_start;
  Stage_seconds m_seconds;
};

template <typename Policy>
Timed_segmentation segment_by(const Benchmark_mesh& mesh, std::size_t number_of_segments,
                              const Policy& policy)
{
  Timed_segmentation result;
  result.labels.resize(num_faces(mesh));
  RS::Merge_tree tree;
  Stage_timer timer;
  result.number_of_segments = RS::segment(mesh, face_map(mesh, result.labels),
                                          RS::parameters::number_of_segments(number_of_segments)
                                              .merging_policy(policy)
                                              .merge_tree(std::ref(tree))
                                              .visitor(std::ref(timer)));
  result.seconds = timer.finish();
  result.number_of_regions = tree.number_of_regions();
  return result;
}

} // namespace

Timed_segmentation segment_by_two_step(const Benchmark_mesh& mesh, std::size_t number_of_segments)
{
  return segment_by(mesh, number_of_segments, RS::Two_step());
}

Timed_segmentation segment_by_best(const Benchmark_mesh& mesh, std::size_t number_of_segments)
{
  return segment_by(mesh, number_of_segments, RS::Best());
}

} // namespace princeton_benchmark
