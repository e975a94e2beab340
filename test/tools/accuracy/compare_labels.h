// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_COMPARE_LABELS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_COMPARE_LABELS_H

#include "Benchmark_mesh.h"
#include "Measures.h"

#include <vector>

namespace princeton_benchmark {

/// All measures of a result against a truth. The labels are those of the faces by index.
Measures compare_labels(const Benchmark_mesh& mesh, const std::vector<int>& result,
                        const std::vector<int>& truth);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_COMPARE_LABELS_H
