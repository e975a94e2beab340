// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_WRITE_REPORT_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_WRITE_REPORT_H

#include "score_tables.h"

#include <iosfwd>

namespace princeton_benchmark {

/// Writes a run as one HTML file that needs no other: the tables, charts of the categories, and the
/// pictures of the models, the worst first.
void write_report(std::ostream& out, const Run& run);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_WRITE_REPORT_H
