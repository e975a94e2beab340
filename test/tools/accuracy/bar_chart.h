// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_BAR_CHART_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_BAR_CHART_H

#include <iosfwd>
#include <string>
#include <vector>

namespace princeton_benchmark {

/// Bars of one color, one in each group; NaN leaves a gap.
struct Bar_series
{
  std::string name, color;
  std::vector<double> values;
};

struct Bar_chart
{
  std::string title;
  std::vector<std::string> groups;
  std::vector<Bar_series> series;
};

/// Writes a chart as an inline SVG element; values are at least 0.
void write_svg(std::ostream& out, const Bar_chart& chart);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_BAR_CHART_H
