// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_csv.h"

#include <cmath>
#include <ostream>
#include <string>

namespace princeton_benchmark {

namespace {

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (char c : text)
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

void write_scores(std::ostream& out, const std::optional<Measures>& measures)
{
  for (std::size_t m = 0; m < number_of_measures; ++m) {
    out << ",";
    if (measures && !std::isnan(measures->values[m]))
      out << measures->values[m];
  }
}

void write_header(std::ostream& out)
{
  out << "model,category,faces,truths,k,segments,regions,seconds_reading,seconds_regions,"
         "seconds_graph,seconds_merging";
  for (const char* protocol : {"standard", "first", "nearest", "automatic", "own_number"})
    for (const char* column : measure_columns)
      out << "," << protocol << "_" << column;
  out << ",automatic_segments,nearest_truth,nearest_truth_distance,failure\n";
}

} // namespace

void write_csv(std::ostream& out, const std::vector<Model_result>& results)
{
  out.precision(9);
  write_header(out);
  for (const Model_result& r : results) {
    out << quoted(r.name) << "," << quoted(r.category);
    if (r.failure.empty()) {
      out << "," << r.number_of_faces << "," << r.number_of_truths << "," << r.wanted_segments
          << "," << r.number_of_segments << "," << r.number_of_regions << "," << r.seconds.reading
          << "," << r.seconds.regions << "," << r.seconds.graph << "," << r.seconds.merging;
      write_scores(out, r.standard);
      write_scores(out, r.first);
      write_scores(out, r.nearest);
      write_scores(out, r.automatic);
      write_scores(out, r.own_number);
      out << "," << r.automatic_segments << "," << quoted(r.nearest_truth) << ","
          << r.nearest_distance << ",";
    } else {
      out << std::string(9 + 5 * number_of_measures + 4, ',') << quoted(r.failure);
    }
    out << "\n";
  }
}

} // namespace princeton_benchmark
