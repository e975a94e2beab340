// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_PLAN_CASES_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_PLAN_CASES_H

#include "Case.h"

#include <cstddef>
#include <vector>

namespace speed_benchmark {

struct Plan
{
  std::vector<std::size_t> sizes;       ///< of the smooth meshes, in faces
  std::vector<std::size_t> noisy_sizes; ///< of the noisy ones
  std::size_t many_segments = 10000; ///< for `two-step` on the noisy mesh of about a million faces
  std::size_t huge = 0;              ///< faces of the torus; 0: none
  std::size_t threads = 1;           ///< of the parallel runs, where the library has them
};

/// All that is run, mesh after mesh.
std::vector<Case> plan_cases(const Plan& plan);

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_PLAN_CASES_H
