// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the methods of the package stand on the Princeton Segmentation Benchmark, in one command.

#include "Princeton_data.h"
#include "Summary.h"
#include "benchmark_options.h"
#include "model_variants.h"
#include "run_benchmark.h"
#include "score_model.h"
#include "score_tables.h"
#include "variants_tables.h"
#include "write_csv.h"
#include "write_report.h"

#include "batch/Progress_line.h"
#include "write/Whole_file.h"
#include "read/errors.h"

#include <exception>
#include <iostream>
#include <optional>
#include <string>

namespace princeton_benchmark {

namespace {

Model_scorer make_scorer(const Benchmark_options& options)
{
  if (options.method == "people")
    return score_people;
  const Method& method = find_method(options.method);
  const Scoring scoring = {options.report_file.empty() ? Pictures::NONE : Pictures::NEAREST_TRUTH,
                           options.number_of_runs};
  return
    [&method, scoring](const Model& model) { return score_segmentation(model, method, scoring); };
}

std::vector<Model_result> run_with_progress(const std::vector<Model_source>& sources,
                                            const Model_scorer& score, std::size_t threads)
{
  segment_mesh::Progress_line line(true);
  const auto show = [&](std::size_t done) {
    line.show(std::to_string(done) + " of " + counted(sources.size(), "model"),
              double(done) / double(sources.size()));
  };
  return run_benchmark(sources, score, threads, show);
}

Run run(const Benchmark_options& options)
{
  std::optional<Princeton_data> data;
  if (!options.data_folder.empty())
    data.emplace(options.data_folder);
  const bool is_people = options.method == "people";
  return {options.method, data.has_value(),
          is_people ? std::nullopt : std::make_optional(find_method(options.method).numbers),
          run_with_progress(data ? princeton_sources(*data) : procedural_sources(),
                            make_scorer(options), options.number_of_threads)};
}

template <typename Writer>
void write_file(const std::string& file, Writer write)
{
  if (file.empty())
    return;
  segment_mesh::Whole_file whole(file);
  write(whole.stream());
  whole.commit();
}

/// A line on stderr for each failure. The exit status.
int report_failures(const std::vector<Model_result>& results)
{
  for (const Model_result& r : results)
    if (!r.failure.empty())
      std::cerr << "princeton_benchmark: "
                << segment_mesh::one_line("model " + r.name + ": " + r.failure) << "\n";
  const std::size_t failures = number_of_failures(results);
  if (failures > 0)
    std::cerr << "princeton_benchmark: " << failures << " of " << counted(results.size(), "model")
              << " failed\n";
  return failures > 0 ? 1 : 0;
}

int run_variants(const Benchmark_options& options)
{
  const std::vector<Model_source> sources = variant_sources(model_variants(*options.variants_seed));
  std::vector<Variants_run> runs;
  std::vector<Model_result> all;
  for (const char* name : {"learned", "visibility", "two-step"}) {
    const Method& method = find_method(name);
    const auto score = [&](const Model& model) { return score_segmentation(model, method); };
    runs.push_back({name, run_with_progress(sources, score, options.number_of_threads)});
    write_text(std::cout, variants_table(runs.back()));
    all.insert(all.end(), runs.back().results.begin(), runs.back().results.end());
  }
  write_text(std::cout, variants_comparison(runs[0], runs[1]));
  write_text(std::cout, variants_comparison(runs[1], runs[2]));
  write_file(options.csv_file, [&](std::ostream& out) { write_csv(out, all); });
  return report_failures(all);
}

int run_program(int argc, char** argv)
{
  const auto parsed = parse_command_line(argc, argv);
  if (const int* exit_status = std::get_if<int>(&parsed))
    return *exit_status;
  const Benchmark_options& options = std::get<Benchmark_options>(parsed);
  if (options.variants_seed)
    return run_variants(options);
  const Run result = run(options);
  for (const Table& table : score_tables(result))
    write_text(std::cout, table);
  std::cout.flush();
  write_file(options.csv_file, [&](std::ostream& out) { write_csv(out, result.results); });
  write_file(options.report_file, [&](std::ostream& out) { write_report(out, result); });
  return report_failures(result.results);
}

} // namespace

} // namespace princeton_benchmark

int main(int argc, char** argv)
{
  try {
    return princeton_benchmark::run_program(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "princeton_benchmark: " << segment_mesh::one_line(error.what()) << "\n";
    return 1;
  }
}
