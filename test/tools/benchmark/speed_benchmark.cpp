// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the speed and the memory of the stages and pipelines, against what the machine and CGAL
// can do: see doc/performance.md. Options of Google Benchmark, as --benchmark_filter, are taken
// too.

#include "Measurement.h"
#include "Mesh_store.h"
#include "Table.h"
#include "describe_run.h"
#include "plan_cases.h"

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <thread>

namespace {

using namespace speed_benchmark;

struct Options
{
  Plan plan;
  std::string meshes, stem = "speed", commit, note;
  double seconds = 3;
};

void add_options(CLI::App& app, Options& options)
{
  app.add_option("--meshes", options.meshes,
                 "Folder of the meshes of CGAL's demos, for all but --huge");
  app.add_option("-o,--output", options.stem, "Writes STEM.csv and STEM.md")->capture_default_str();
  app.add_option("--sizes", options.plan.sizes, "Numbers of faces, about")->delimiter(',');
  app.add_option("--noisy-sizes", options.plan.noisy_sizes, "Same of the noisy mesh")
    ->delimiter(',');
  app.add_option("--huge", options.plan.huge, "Also a torus of so many faces, about");
  app.add_option("--seconds", options.seconds, "For each line, but at least three rounds")
    ->capture_default_str();
  app.add_option("--commit", options.commit, "Goes to the head of the table");
  app.add_option("--note", options.note, "Goes to the head of the table");
}

Contest make_contest(const Case& c, const Subjects& subjects, const Sums* sums)
{
  Contest contest;
  if (sums) {
    contest.floor = [=] {
      return seconds_of(Clock::WALL, [&] { benchmark::DoNotOptimize(sums->in_parallel()); });
    };
    contest.slow_floor = [=] {
      return seconds_of(Clock::WALL, [&] { benchmark::DoNotOptimize(sums->on_one_thread()); });
    };
  } else
    contest.floor = [=] { return subjects.surface_mesh.seconds_of_face_normals(); };
  contest.subject = [&c, subjects] { return c.run(subjects); };
  if (c.run_reference)
    contest.reference = [&c, subjects] { return c.run_reference(subjects); };
  contest.compared_until = c.compared_until;
  return contest;
}

/// One iteration for Google Benchmark: the rounds are in it.
void run(benchmark::State& state, const Case& c, const Options& options, Mesh_store& store,
         Table& table)
{
  const auto subjects = store.get(c.mesh);
  if (!subjects) {
    state.SkipWithError("this mesh type is missing");
    return;
  }
  if (c.is_call)
    subjects->surface_mesh.prepare_calls();
  const std::size_t faces = subjects->subject.number_of_faces();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, c.threads);
  const Contest contest = make_contest(c, *subjects, c.threads > 1 ? &store.sums() : nullptr);
  for (auto _ : state) {
    const Measurement measurement = measure(contest, options.seconds);
    state.SetIterationTime(measurement.seconds);
    const Numbers line = numbers(c, faces, measurement);
    for (const auto& [column, value] : line)
      if (value)
        state.counters[column] = *value;
    table.add_line(c, line);
    table.write(describe_memory());
  }
}

int run_all(Options& options)
{
#ifdef REGION_SEGMENTATION_BENCHMARK_PARALLEL
  options.plan.threads = std::thread::hardware_concurrency();
#endif
  Mesh_store store(options.meshes);
  const Facts facts = describe_run(options.commit, options.note);
  for (const auto& [key, value] : facts)
    benchmark::AddCustomContext(key, value);
  Table table(options.stem, facts);
  const std::vector<Case> cases = plan_cases(options.plan);
  for (const Case& c : cases)
    benchmark::RegisterBenchmark(
      name(c).c_str(), [&](benchmark::State& state) { run(state, c, options, store, table); })
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  std::cout << options.stem << ".csv and " << options.stem << ".md are written\n";
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  CLI::App app("Measures the speed and the memory of mesh segmentation.");
  Options options;
  add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    return run_all(options);
  } catch (const std::exception& error) {
    std::cerr << "speed_benchmark: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
