// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_TABLE_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_TABLE_H

#include <iosfwd>
#include <string>
#include <vector>

namespace princeton_benchmark {

/// A table for the terminal and for the report. The first column holds names, the others numbers.
struct Table
{
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes; ///< below the table
};

void write_text(std::ostream& out, const Table& table);
void write_html(std::ostream& out, const Table& table);

/// With four decimals, a dash for NaN.
std::string score(double value);
/// With three decimals, as others print theirs.
std::string published_score(double value);
std::string seconds(double value);
/// `2 models`, `1 model`.
std::string counted(std::size_t number, const std::string& thing);
/// Text as it stands in HTML.
std::string html(const std::string& text);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_TABLE_H
