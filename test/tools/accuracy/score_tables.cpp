// SPDX-License-Identifier: GPL-3.0-or-later

#include "score_tables.h"

#include "Summary.h"
#include "published_figures.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace princeton_benchmark {

namespace {

using Row = std::vector<std::string>;

const std::string what = "1 - Rand index";

void append_scores(Row& row, const Measures& measures)
{
  for (double value : measures.values)
    row.push_back(score(value));
}

Row header_of_measures(Row first)
{
  first.insert(first.end(), measure_names.begin(), measure_names.end());
  return first;
}

bool takes_number(const Run& run)
{
  return run.numbers && *run.numbers != Numbers::CHOSEN;
}

bool chooses_number(const Run& run)
{
  return run.numbers && *run.numbers != Numbers::GIVEN;
}

/// What a reader must know who takes a mean from the table.
std::vector<std::string> notes_on(const Run& run, const Summary& summary)
{
  std::vector<std::string> notes = {counted(summary.number_of_models, "model") + " of " +
                                    std::to_string(run.results.size()) + " scored."};
  if (const std::size_t n = number_of_failures(run.results))
    notes.push_back(counted(n, "model") + " FAILED and in no mean.");
  if (const std::size_t n = number_of_undefined_cuts(run.results))
    notes.push_back("CD is not defined for " + counted(n, "comparison") +
                    ", which its means leave out.");
  if ((run.method == "visibility" || run.method == "learned") && run.is_princeton)
    notes.push_back("The constants of " + run.method +
                    " were chosen on half of this benchmark (see doc/accuracy.md): on "
                    "those models its scores are no test.");
  const std::size_t n = takes_number(run) ? number_of_other_numbers(run.results) : 0;
  if (n > 0)
    notes.push_back(counted(n, "result") + " without the wanted number of segments.");
  return notes;
}

double value_of(const Category_score* category)
{
  return category ? category->mean[RAND_INDEX] : std::numeric_limits<double>::quiet_NaN();
}

/// A row for each category, and two for the means.
void append_summary(Table& table, const Summary& summary)
{
  const auto append = [&](const std::string& name, std::size_t models, const Measures& mean) {
    Row row = {name, std::to_string(models)};
    append_scores(row, mean);
    table.rows.push_back(row);
  };
  for (const Category_score& c : summary.categories)
    append(c.name, c.number_of_models, c.mean);
  append("mean over categories", summary.number_of_models, summary.over_categories);
  append("mean over models", summary.number_of_models, summary.over_models);
}

std::vector<double> sorted_seconds(const Run& run)
{
  std::vector<double> result;
  for (const Model_result& r : run.results)
    if (r.failure.empty())
      result.push_back(r.seconds.total());
  std::sort(result.begin(), result.end());
  return result;
}

double mean_seconds(const Run& run)
{
  const std::vector<double> all = sorted_seconds(run);
  return all.empty() ? 0 : std::accumulate(all.begin(), all.end(), 0.0) / double(all.size());
}

/// Nothing where no model was segmented.
std::vector<std::string> note_on_times(const Run& run)
{
  const std::vector<double> all = sorted_seconds(run);
  if (all.empty() || !run.numbers)
    return {};
  return {"CPU seconds of this run, one core a model: " + seconds(all[all.size() / 2]) +
          " in the median, at most " + seconds(all.back()) + "."};
}

/// This run with each method of choosing the number of segments.
void append_own_rows(Table& table, const Run& run)
{
  const auto append = [&](Protocol protocol, const char* number) {
    const Summary summary = summarize(run.results, protocol);
    table.rows.push_back({run.method + " (this run)", score(summary.over_categories[RAND_INDEX]),
                          run.numbers ? seconds(mean_seconds(run)) : "-", number});
  };
  if (takes_number(run))
    append(standard_protocol, "given");
  if (chooses_number(run))
    append(automatic_protocol, "auto");
  if (takes_number(run))
    append(own_number_protocol, "of each person");
  if (!run.numbers)
    append(standard_protocol, "-");
}

Row published_row(const Published_category& row, const std::string& first,
                  const std::string& nearest)
{
  return {row.name,
          first,
          nearest,
          published_score(row.paper),
          published_score(row.randomized_cuts),
          published_score(row.random_walks)};
}

} // namespace

std::vector<Table> score_tables(const Run& run)
{
  if (!run.is_princeton)
    return {models_table(run)};
  std::vector<Table> tables = {published_standard_table(run), standard_categories_table(run),
                               paper_measures_table(run), paper_categories_table(run)};
  if (run.numbers) {
    tables.insert(tables.begin() + 2, numbers_table(run));
    tables.push_back(times_table(run));
  }
  return tables;
}

Table published_standard_table(const Run& run)
{
  const Summary summary = summarize(run.results, standard_protocol);
  Table table{"Standard protocol: " + what + ", beside published figures of the same protocol",
              {"method", "mean", "seconds", "k"},
              {},
              notes_on(run, summary)};
  append_own_rows(table, run);
  for (const Published_method& m : published_methods)
    table.rows.push_back({m.name, published_score(m.mean), m.seconds, m.number_of_segments});
  table.notes.push_back(
    "The published figures are of all 380 models; people score 0.0976 on the even half.");
  if (takes_number(run))
    table.notes.push_back(
      "Of each person: each human segmentation is compared with the result that "
      "has as many segments.");
  for (const std::string& note : note_on_times(run))
    table.notes.push_back(note);
  return table;
}

Table standard_categories_table(const Run& run)
{
  const Summary summary = summarize(run.results, standard_protocol);
  Table table{"Standard protocol: all measures, mean of each category",
              header_of_measures({"category", "models"}),
              {},
              notes_on(run, summary)};
  append_summary(table, summary);
  return table;
}

Table numbers_table(const Run& run)
{
  const Summary standard = summarize(run.results, standard_protocol);
  const Summary automatic = summarize(run.results, automatic_protocol);
  const Summary own = summarize(run.results, own_number_protocol);
  Table table{"Standard protocol: " + what + " by where the number of segments comes from",
              {"category", "given", "automatic", "of each person"},
              {},
              notes_on(run, standard)};
  const auto append = [&](const std::string& name, double given, double chosen, double each) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    table.rows.push_back({name, score(takes_number(run) ? given : none),
                          score(chooses_number(run) ? chosen : none),
                          score(takes_number(run) ? each : none)});
  };
  for (const Category_score& c : standard.categories)
    append(c.name, c.mean[RAND_INDEX], value_of(automatic.category(c.name)),
           value_of(own.category(c.name)));
  append("mean over categories", standard.over_categories[RAND_INDEX],
         automatic.over_categories[RAND_INDEX], own.over_categories[RAND_INDEX]);
  return table;
}

Table paper_measures_table(const Run& run)
{
  const Summary first = summarize(run.results, paper_first_protocol);
  const Summary nearest = summarize(run.results, paper_nearest_protocol);
  Table table{"The paper's protocol: all measures, means over the models",
              header_of_measures({"truth", "models"}),
              {},
              notes_on(run, first)};
  const auto append = [&](const std::string& name, const Summary& summary) {
    Row row = {name, std::to_string(summary.number_of_models)};
    append_scores(row, summary.over_models);
    table.rows.push_back(row);
  };
  append("first person of the most common number", first);
  append("nearest person of the most common number", nearest);
  return table;
}

Table paper_categories_table(const Run& run)
{
  const Summary first = summarize(run.results, paper_first_protocol);
  const Summary nearest = summarize(run.results, paper_nearest_protocol);
  Table table{"The paper's protocol: " + what + ", beside published figures of the same protocol",
              {"category", run.method + ", first", run.method + ", nearest", "the paper",
               "Randomized Cuts", "Random Walks"},
              {},
              notes_on(run, first)};
  for (const Published_category& row : published_categories)
    table.rows.push_back(published_row(row, score(value_of(first.category(row.name))),
                                       score(value_of(nearest.category(row.name)))));
  const auto& [printed, models, categories] = published_means;
  table.rows.push_back(published_row(printed, "", ""));
  table.rows.push_back(published_row(models, score(first.over_models[RAND_INDEX]),
                                     score(nearest.over_models[RAND_INDEX])));
  table.rows.push_back(published_row(categories, score(first.over_categories[RAND_INDEX]),
                                     score(nearest.over_categories[RAND_INDEX])));
  table.notes.push_back("The published figures are of 364 models. People on all of them: " +
                        published_score(published_people_first) + " (first), " +
                        published_score(published_people_nearest) + " (nearest).");
  return table;
}

Table models_table(const Run& run)
{
  const Summary summary = summarize(run.results, standard_protocol);
  Table table{
    "Scores of each model",
    header_of_measures({"model", "faces", "k", "segments", "seconds", "auto k", "auto 1-RI"}),
    {},
    notes_on(run, summary)};
  for (const Model_result& r : run.results) {
    Row row = {r.name};
    if (r.failure.empty()) {
      row.insert(row.end(), {std::to_string(r.number_of_faces), std::to_string(r.wanted_segments),
                             std::to_string(r.number_of_segments), seconds(r.seconds.total()),
                             r.automatic ? std::to_string(r.automatic_segments) : "-",
                             r.automatic ? score((*r.automatic)[RAND_INDEX]) : "-"});
      append_scores(row, r.standard);
    } else {
      row.push_back("failed");
    }
    table.rows.push_back(row);
  }
  const Summary automatic = summarize(run.results, automatic_protocol);
  Row mean = {"mean",
              "",
              "",
              "",
              seconds(mean_seconds(run)),
              "",
              chooses_number(run) ? score(automatic.over_models[RAND_INDEX]) : "-"};
  append_scores(mean, summary.over_models);
  table.rows.push_back(mean);
  return table;
}

} // namespace princeton_benchmark
