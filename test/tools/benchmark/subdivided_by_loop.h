// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SUBDIVIDED_BY_LOOP_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SUBDIVIDED_BY_LOOP_H

#include "Triangles.h"

namespace speed_benchmark {

/// Splits every triangle into four by Loop's scheme, which smooths creases away. Faces are in the
/// order of `CGAL::Subdivision_method_3`: the four are not side by side.
Triangles subdivided_by_loop(const Triangles& coarse);

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SUBDIVIDED_BY_LOOP_H
