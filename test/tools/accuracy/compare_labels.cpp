// SPDX-License-Identifier: GPL-3.0-or-later

#include "compare_labels.h"

#include <CGAL/Region_segmentation/Evaluation/evaluation.h>

namespace princeton_benchmark {

namespace RS = CGAL::Region_segmentation;

Measures compare_labels(const Benchmark_mesh& mesh, const std::vector<int>& result,
                        const std::vector<int>& truth)
{
  const auto a = face_map(mesh, result);
  const auto b = face_map(mesh, truth);
  const RS::Hamming_distance hamming = RS::hamming_distance(mesh, a, b);
  const RS::Consistency_error error = RS::consistency_error(mesh, a, b);
  Measures measures;
  measures.values[RAND_INDEX] = RS::rand_index_distance(mesh, a, b);
  measures.values[CUT_DISCREPANCY] = RS::cut_discrepancy(mesh, a, b)
                                       .value_or(std::numeric_limits<double>::quiet_NaN());
  measures.values[HAMMING] = hamming.distance;
  measures.values[MISSING_RATE] = hamming.missing_rate;
  measures.values[FALSE_ALARM_RATE] = hamming.false_alarm_rate;
  measures.values[GCE] = error.global;
  measures.values[LCE] = error.local;
  measures.values[GCE_AREA] = error.global_by_area;
  measures.values[LCE_AREA] = error.local_by_area;
  return measures;
}

} // namespace princeton_benchmark
