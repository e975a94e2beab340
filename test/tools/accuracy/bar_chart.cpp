// SPDX-License-Identifier: GPL-3.0-or-later

#include "bar_chart.h"

#include "Table.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace princeton_benchmark {

namespace {

constexpr double left = 40, top = 34, plot_height = 220, group_gap = 10;

/// Where everything is, in SVG units.
struct Layout
{
  double bar_width, group_width, width, top_value;

  explicit Layout(const Bar_chart& chart)
  {
    const double series = double(chart.series.size());
    bar_width = series > 2 ? 10 : 22;
    group_width = series * bar_width + group_gap;
    width = left + group_width * double(chart.groups.size()) + 10;
    double largest = 0;
    for (const Bar_series& s : chart.series)
      for (double value : s.values)
        largest = std::fmax(largest, value);
    top_value = (std::max)(0.1, std::ceil(largest * 10) / 10);
  }

  double y(double value) const { return top + plot_height * (1 - value / top_value); }
};

void write_axis(std::ostream& out, const Layout& layout)
{
  const double step = layout.top_value > 0.45 ? 0.1 : 0.05;
  for (int i = 0; i * step < layout.top_value + step / 2; ++i) {
    const double value = i * step;
    out << "<line x1=\"" << left << "\" x2=\"" << layout.width - 5 << "\" y1=\"" << layout.y(value)
        << "\" y2=\"" << layout.y(value) << "\" stroke=\"#ddd\"/><text x=\"" << left - 6
        << "\" y=\"" << layout.y(value) + 4 << "\" text-anchor=\"end\">" << value << "</text>\n";
  }
}

void write_legend(std::ostream& out, const Bar_chart& chart)
{
  double x = left;
  for (const Bar_series& s : chart.series) {
    out << "<rect x=\"" << x << "\" y=\"8\" width=\"12\" height=\"12\" fill=\"" << s.color
        << "\"/><text x=\"" << x + 17 << "\" y=\"18\">" << html(s.name) << "</text>\n";
    x += 40 + 7 * double(s.name.size());
  }
}

void write_group(std::ostream& out, const Bar_chart& chart, const Layout& layout, std::size_t group)
{
  const double x = left + group_gap / 2 + layout.group_width * double(group);
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const double value = chart.series[i].values[group];
    if (std::isnan(value))
      continue;
    out << "<rect x=\"" << x + layout.bar_width * double(i) << "\" y=\"" << layout.y(value)
        << "\" width=\"" << layout.bar_width - 1 << "\" height=\""
        << top + plot_height - layout.y(value) << "\" fill=\"" << chart.series[i].color
        << "\"><title>" << html(chart.groups[group]) << ", " << html(chart.series[i].name) << ": "
        << score(value) << "</title></rect>\n";
  }
  const double middle = x + (layout.group_width - group_gap) / 2, base = top + plot_height + 12;
  out << "<text transform=\"translate(" << middle + 4 << "," << base
      << ") rotate(-40)\" text-anchor=\"end\">" << html(chart.groups[group]) << "</text>\n";
}

} // namespace

void write_svg(std::ostream& out, const Bar_chart& chart)
{
  const Layout layout(chart);
  const double height = top + plot_height + 75;
  out << "<h3>" << html(chart.title) << "</h3>\n<svg viewBox=\"0 0 " << layout.width << " "
      << height << "\" width=\"" << layout.width << "\" height=\"" << height
      << "\" role=\"img\" font-family=\"sans-serif\" font-size=\"11\">\n";
  write_axis(out, layout);
  write_legend(out, chart);
  for (std::size_t group = 0; group < chart.groups.size(); ++group)
    write_group(out, chart, layout, group);
  out << "</svg>\n";
}

} // namespace princeton_benchmark
