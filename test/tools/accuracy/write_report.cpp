// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_report.h"

#include "Summary.h"
#include "bar_chart.h"
#include "published_figures.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>
#include <ostream>

namespace princeton_benchmark {

namespace {

constexpr const char* style = R"(<style>
body { font: 15px/1.45 sans-serif; color: #222; max-width: 1240px; margin: 2em auto; padding: 0 1em }
h2 { font-size: 1.1em; margin: 2.2em 0 .5em }
h3 { font-size: 1em; margin: 1.6em 0 .3em }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums }
th, td { padding: .18em .8em; text-align: right; border-bottom: 1px solid #e4e4e4 }
th { border-bottom: 2px solid #999 }
th:first-child, td:first-child { text-align: left }
.note { font-size: 13px; color: #666; margin: .3em 0 }
.failed { color: #b00 }
.models { display: flex; flex-wrap: wrap; gap: 14px }
figure { margin: 0; border: 1px solid #ddd; border-radius: 4px; padding: 6px; width: 560px }
figure img { width: 100%; height: auto; display: block }
figcaption { font-size: 13px; display: flex; justify-content: space-between }
</style>
)";

std::string base64(std::string bytes)
{
  namespace codec = boost::archive::iterators;
  using Iterator = codec::base64_from_binary<codec::transform_width<const char*, 6, 8>>;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.append(padding, '\0');
  std::string text(Iterator(bytes.data()), Iterator(bytes.data() + bytes.size()));
  return text.replace(text.size() - padding, padding, padding, '=');
}

/// The values of a summary for the categories that are drawn.
Bar_series series(const std::string& name, const std::string& color, const Summary& summary,
                  const std::vector<std::string>& categories)
{
  Bar_series result{name, color, {}};
  for (const std::string& category : categories) {
    const Category_score* found = summary.category(category);
    result.values.push_back(found ? found->mean[RAND_INDEX]
                                  : std::numeric_limits<double>::quiet_NaN());
  }
  return result;
}

void write_standard_chart(std::ostream& out, const Run& run)
{
  const Summary summary = summarize(run.results, standard_protocol);
  Bar_chart chart{run.is_princeton ? "Standard protocol: 1 - Rand index of each category"
                                   : "1 - Rand index of each model",
                  {},
                  {}};
  for (const Category_score& c : summary.categories)
    chart.groups.push_back(c.name);
  chart.series = {series(run.method, "#4477aa", summary, chart.groups)};
  write_svg(out, chart);
}

void write_paper_chart(std::ostream& out, const Run& run)
{
  Bar_chart chart{"The paper's protocol: 1 - Rand index of each category", {}, {}};
  Bar_series paper{"the paper", "#999999", {}}, cuts{"Randomized Cuts", "#dddddd", {}};
  for (const Published_category& row : published_categories) {
    chart.groups.push_back(row.name);
    paper.values.push_back(row.paper);
    cuts.values.push_back(row.randomized_cuts);
  }
  chart.series = {series(run.method + ", first", "#4477aa",
                         summarize(run.results, paper_first_protocol), chart.groups),
                  series(run.method + ", nearest", "#66ccee",
                         summarize(run.results, paper_nearest_protocol), chart.groups),
                  paper, cuts};
  write_svg(out, chart);
}

void write_failures(std::ostream& out, const Run& run)
{
  if (number_of_failures(run.results) == 0)
    return;
  out << "<h2>Failed</h2>\n<ul class=\"failed\">\n";
  for (const Model_result& r : run.results)
    if (!r.failure.empty())
      out << "<li>" << html(r.name) << " (" << html(r.category) << "): " << html(r.failure)
          << "</li>\n";
  out << "</ul>\n";
}

void write_model(std::ostream& out, const Model_result& r)
{
  const std::string name = r.name == r.category ? r.name : r.category + " " + r.name;
  out << "<figure><img alt=\"" << html(name) << "\" width=\"" << r.picture.width << "\" height=\""
      << r.picture.height << "\" loading=\"lazy\" src=\"data:image/png;base64,"
      << base64(r.picture.png) << "\"><figcaption><span><b>" << html(name) << "</b>: mean "
      << score(r.standard[RAND_INDEX]) << ", " << counted(r.number_of_segments, "segment");
  if (r.number_of_segments != r.wanted_segments)
    out << " of " << r.wanted_segments;
  out << "</span><span>" << html(r.nearest_truth) << ": " << score(r.nearest_distance)
      << "</span></figcaption></figure>\n";
}

/// Those with the largest mean distance first.
void write_models(std::ostream& out, const Run& run)
{
  std::vector<const Model_result*> order;
  for (const Model_result& r : run.results)
    if (!r.picture.png.empty())
      order.push_back(&r);
  if (order.empty())
    return;
  std::stable_sort(order.begin(), order.end(), [](const Model_result* a, const Model_result* b) {
    return a->standard[RAND_INDEX] > b->standard[RAND_INDEX];
  });
  out << "<h2>Models, the worst first</h2>\n<p>On the left the result, on the right the nearest "
         "truth, its segments in the colors of those they share the most faces with. The mean is "
         "over "
         "all truths.</p>\n<div class=\"models\">\n";
  for (const Model_result* r : order)
    write_model(out, *r);
  out << "</div>\n";
}

} // namespace

void write_report(std::ostream& out, const Run& run)
{
  const std::string title = (run.is_princeton ? "Princeton Segmentation Benchmark: "
                                              : "Procedural models: ") +
                            run.method;
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>"
      << html(title) << "</title>\n"
      << style << "</head>\n<body>\n<h1>" << html(title) << "</h1>\n"
      << "<p>All scores are dissimilarities: 0 is equal, lower is better.</p>\n";
  write_failures(out, run);
  for (const Table& table : score_tables(run))
    write_html(out, table);
  out << "<h2>Categories</h2>\n";
  write_standard_chart(out, run);
  if (run.is_princeton)
    write_paper_chart(out, run);
  write_models(out, run);
  out << "</body>\n</html>\n";
}

} // namespace princeton_benchmark
