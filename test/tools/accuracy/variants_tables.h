// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_VARIANTS_TABLES_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_VARIANTS_TABLES_H

#include "Model_result.h"
#include "Table.h"

#include <string>
#include <vector>

namespace princeton_benchmark {

/// The results of a method on every variant (a category) of every model.
struct Variants_run
{
  std::string method;
  std::vector<Model_result> results;
};

/// 1 - Rand index, models by variants, and the means.
Table variants_table(const Variants_run& run);

/// How far `method` is from `other` in each variant. \pre they have the same models in one order
Table variants_comparison(const Variants_run& method, const Variants_run& other);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_VARIANTS_TABLES_H
