// SPDX-License-Identifier: GPL-3.0-or-later

#include "variants_tables.h"

#include "Summary.h"

#include <algorithm>

namespace princeton_benchmark {

namespace {

/// A row for each model, in the order of the first variant.
void append_models(Table& table, const std::vector<Model_result>& results)
{
  for (const Model_result& result : results) {
    const std::string value = result.failure.empty() ? score(result.standard[RAND_INDEX])
                                                     : "failed";
    const auto row = std::find_if(table.rows.begin(), table.rows.end(),
                                  [&](const auto& r) { return r.front() == result.name; });
    if (row == table.rows.end())
      table.rows.push_back({result.name, value});
    else
      row->push_back(value);
  }
}

/// Above it a model is called behind.
constexpr double tolerance = 0.01;

struct Difference
{
  double largest = -1;
  std::string model, behind;
};

Difference compare(const std::string& variant, const Variants_run& method,
                   const Variants_run& other)
{
  Difference result;
  for (std::size_t i = 0; i < method.results.size(); ++i) {
    const Model_result &mine = method.results[i], &theirs = other.results[i];
    if (mine.category != variant || !mine.failure.empty() || !theirs.failure.empty())
      continue;
    const double difference = mine.standard[RAND_INDEX] - theirs.standard[RAND_INDEX];
    if (difference > tolerance)
      result.behind += (result.behind.empty() ? "" : " ") + mine.name;
    if (difference > result.largest) {
      result.largest = difference;
      result.model = mine.name;
    }
  }
  return result;
}

} // namespace

Table variants_table(const Variants_run& run)
{
  const Summary summary = summarize(run.results, standard_protocol);
  Table table{"1 - Rand index of " + run.method + " on variants of each model", {"model"}, {}, {}};
  append_models(table, run.results);
  std::vector<std::string> mean = {"mean"};
  for (const Category_score& variant : summary.categories) {
    table.header.push_back(variant.name);
    mean.push_back(score(variant.mean[RAND_INDEX]));
  }
  table.rows.push_back(mean);
  table.notes = {
    "Finer: made with 4 times the faces; coarser: with a quarter; in four: each face "
    "split into four.",
    "Noise N: of 0.5 % of the mean edge length, with the seed N; flips N: other diagonals, "
    "with the seed N."};
  return table;
}

Table variants_comparison(const Variants_run& method, const Variants_run& other)
{
  const Summary mine = summarize(method.results, standard_protocol);
  const Summary theirs = summarize(other.results, standard_protocol);
  Table table{
    method.method + " beside " + other.method,
    {"variant", method.method, other.method, "largest difference", "of", "behind by > 0.01"},
    {},
    {}};
  for (const Category_score& variant : mine.categories) {
    const Category_score* counterpart = theirs.category(variant.name);
    const Difference d = compare(variant.name, method, other);
    table.rows.push_back({variant.name, score(variant.mean[RAND_INDEX]),
                          counterpart ? score(counterpart->mean[RAND_INDEX]) : "-",
                          score(d.largest), d.model, d.behind.empty() ? "-" : d.behind});
  }
  return table;
}

} // namespace princeton_benchmark
