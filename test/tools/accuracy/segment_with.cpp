// SPDX-License-Identifier: GPL-3.0-or-later

#include "segment_with.h"
#include "thread_seconds.h"

#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>

#include <algorithm>
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
  bool on_progress(const std::string& stage, double)
  {
    if (stage != m_stage) {
      finish();
      m_stage = stage;
    }
    return true;
  }

  Stage_seconds finish()
  {
    const double now = thread_seconds();
    if (!m_stage.empty())
      place() += now - m_start;
    m_start = now;
    return m_seconds;
  }

private:
  double& place()
  {
    return m_stage == "reading"   ? m_seconds.reading
           : m_stage == "regions" ? m_seconds.regions
           : m_stage == "graph"   ? m_seconds.graph
                                  : m_seconds.merging;
  }

  std::string m_stage;
  double m_start = 0;
  Stage_seconds m_seconds;
};

template <typename Parameters>
Timed_segmentation segment_with(const Parameters& parameters, const Benchmark_mesh& mesh)
{
  Timed_segmentation result;
  result.labels.resize(num_faces(mesh));
  RS::Merge_tree tree;
  Stage_timer timer;
  result.number_of_segments = RS::segment(mesh, face_map(mesh, result.labels),
                                          parameters.merge_tree(tree).visitor(std::ref(timer)));
  result.seconds = timer.finish();
  result.number_of_regions = tree.number_of_regions();
  return result;
}

Timed_segmentation segment_by_two_step(const Benchmark_mesh& mesh, Wanted_number number)
{
  return segment_with(RS::parameters::method(RS::Two_step()).number_of_segments(number.value()),
                      mesh);
}

/// By a method that can choose the number.
template <typename Segmentation_method>
Timed_segmentation segment_by(const Benchmark_mesh& mesh, Wanted_number number)
{
  const auto parameters = RS::parameters::method(Segmentation_method());
  return number ? segment_with(parameters.number_of_segments(*number), mesh)
                : segment_with(parameters, mesh);
}

} // namespace

const std::vector<Method>& methods()
{
  static const std::vector<Method> all = {
    {"learned", segment_by<RS::Learned_merging>, Numbers::BOTH},
    {"visibility", segment_by<RS::Visibility_merging>, Numbers::BOTH},
    {"two-step", segment_by_two_step, Numbers::GIVEN},
    {"concave-angles", segment_by_concave_angles, Numbers::GIVEN},
    {"sdf", segment_by_sdf, Numbers::CHOSEN}};
  return all;
}

const Method& find_method(const std::string& name)
{
  return *std::find_if(methods().begin(), methods().end(),
                       [&](const Method& m) { return m.name == name; });
}

} // namespace princeton_benchmark
