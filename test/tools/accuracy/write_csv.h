// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_WRITE_CSV_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_WRITE_CSV_H

#include "Model_result.h"

#include <iosfwd>
#include <vector>

namespace princeton_benchmark {

/// A line for each model, in their order, with all that is known of it; a field is empty where
/// there is nothing. The first line names the columns.
void write_csv(std::ostream& out, const std::vector<Model_result>& results);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_WRITE_CSV_H
