// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_ACCURACY_SEGMENT_WITH_H
#define CGAL_REGION_SEGMENTATION_TEST_ACCURACY_SEGMENT_WITH_H

#include "Benchmark_mesh.h"
#include "Model_result.h"

#include <cstddef>
#include <vector>

namespace princeton_benchmark {

/// What a method makes of a mesh.
struct Timed_segmentation
{
  std::vector<int> labels; ///< of the faces by index
  std::size_t number_of_segments = 0, number_of_regions = 0;
  Stage_seconds seconds;
};

/// A segmentation method of the library, with all its constants as they are by default.
using Segmenter = Timed_segmentation (*)(const Benchmark_mesh& mesh,
                                         std::size_t number_of_segments);

Timed_segmentation segment_by_two_step(const Benchmark_mesh& mesh, std::size_t number_of_segments);
Timed_segmentation segment_by_best(const Benchmark_mesh& mesh, std::size_t number_of_segments);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_ACCURACY_SEGMENT_WITH_H
