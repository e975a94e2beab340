// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_DESCRIBE_RUN_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_DESCRIBE_RUN_H

#include "Table.h"

#include <string>

namespace speed_benchmark {

/// Machine, compiler, flags, versions, and how much else the machine does as the run begins.
Facts describe_run(const std::string& commit, const std::string& note);

/// The most memory that the process had in use so far, meshes included.
Facts describe_memory();

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_DESCRIBE_RUN_H
