// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SCORE_TABLES_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SCORE_TABLES_H

#include "Model_result.h"
#include "Table.h"
#include "segment_with.h"

#include <optional>
#include <string>
#include <vector>

namespace princeton_benchmark {

/// What was run.
struct Run
{
  std::string method;
  bool is_princeton = true; ///< else the procedural models, for which nothing is published
  /// Which numbers of segments the method can be asked for; empty where it compares truths alone,
  /// as `people`.
  std::optional<Numbers> numbers;
  std::vector<Model_result> results;
};

/// All tables of a run. Figures of the two protocols are never in one table.
std::vector<Table> score_tables(const Run& run);

/// \name One function a table
/// @{
Table published_standard_table(const Run& run);
Table standard_categories_table(const Run& run);
Table numbers_table(const Run& run);
Table paper_measures_table(const Run& run);
Table paper_categories_table(const Run& run);
Table times_table(const Run& run);
Table models_table(const Run& run);
/// @}

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SCORE_TABLES_H
