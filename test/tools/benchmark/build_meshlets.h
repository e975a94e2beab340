// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_BUILD_MESHLETS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_BUILD_MESHLETS_H

#include "cgal_methods.h"

#include <cstddef>

namespace speed_benchmark {

/// Clusters for rendering by meshoptimizer, of at most 64 vertices and 124 triangles. Returns their
/// number. With the arrays that it reads; which face is in which cluster is not among its results.
std::size_t build_meshlets(const Surface_mesh& mesh);

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_BUILD_MESHLETS_H
