// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_RUN_BENCHMARK_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_RUN_BENCHMARK_H

#include "Model_result.h"
#include "model_sources.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace princeton_benchmark {

/// Scores a model; fills all but the names of its result. Called by several threads at a time.
/// \throws std::exception
using Model_scorer = std::function<Model_result(const Model&)>;

/// Hears how many models are done. Called by one thread at a time.
using Progress_listener = std::function<void(std::size_t done)>;

/// The results in the order of the sources, for any number of threads (at least 1). A model that
/// fails is included, with the reason.
std::vector<Model_result> run_benchmark(const std::vector<Model_source>& sources,
                                        const Model_scorer& score, std::size_t number_of_threads,
                                        const Progress_listener& progress);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_RUN_BENCHMARK_H
