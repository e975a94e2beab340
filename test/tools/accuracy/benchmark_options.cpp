// SPDX-License-Identifier: GPL-3.0-or-later

#include "benchmark_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <thread>

namespace princeton_benchmark {

namespace {

constexpr const char* description = "Scores a segmentation method on the Princeton Segmentation "
                                    "Benchmark, in the standard protocol "
                                    "and\nin the paper's, beside published figures; without "
                                    "--data, on models that the program makes.";

constexpr const char* footer =
  "\nExamples:\n"
  "  princeton_benchmark --data psb --method two-step --report two-step.html\n"
  "  princeton_benchmark --data psb --method people\n"
  "  princeton_benchmark --procedural --csv scores.csv\n"
  "  princeton_benchmark --variants 1\n"
  "\nExit status: 0 done; 1 a model failed, or a file could not be written; 2 wrong usage.";

} // namespace

std::variant<Benchmark_options, int> parse_command_line(int argc, char** argv)
{
  Benchmark_options options;
  options.number_of_threads = (std::max)(1u, std::thread::hardware_concurrency());
  bool is_procedural = false;

  CLI::App app(description, "princeton_benchmark");
  app.footer(footer);
  CLI::Option* data = app
                        .add_option("--data", options.data_folder,
                                    "The benchmark in its own layout: data/off/N.off, "
                                    "data/seg/Benchmark/N/N_j.seg, util/parameters")
                        ->check(CLI::ExistingDirectory)
                        ->type_name("DIR");
  app.add_flag("--procedural", is_procedural, "The models that segment_mesh makes (default)")
    ->excludes(data);
  CLI::Option* variants = app
                            .add_option("--variants", options.variants_seed,
                                        "learned, visibility and two-step on those models with "
                                        "noise, finer, coarser and triangulated "
                                        "otherwise; SEED: of what is random there")
                            ->excludes(data)
                            ->type_name("SEED");
  CLI::Option* method = app
                          .add_option("--method", options.method,
                                      "learned (default), visibility, two-step, concave-angles "
                                      "(single faces merged as in MeshLib), sdf (CGAL's SDF "
                                      "segmentation, which chooses the number of segments), or "
                                      "people: each human segmentation against the "
                                      "others")
                          ->check(CLI::IsMember({"learned", "visibility", "two-step",
                                                 "concave-angles", "sdf", "people"}))
                          ->type_name("METHOD");
  variants->excludes(method);
  app.add_option("--threads", options.number_of_threads, "Models at a time; default: all cores")
    ->check(CLI::Range(1, 1024))
    ->type_name("N");
  app
    .add_option("--runs", options.number_of_runs,
                "Runs of each model; the times are CPU times of the fastest. Default: 1")
    ->check(CLI::Range(1, 1000))
    ->type_name("N");
  app.add_option("--csv", options.csv_file, "A line for each model")->type_name("FILE");
  app
    .add_option("--report", options.report_file,
                "Tables, charts and a picture of each model, the worst first, in one HTML file")
    ->type_name("FILE");
  try {
    app.parse(argc, argv);
    if (options.data_folder.empty() && options.method == "people")
      throw CLI::ValidationError("--method", "people needs --data: each model here has one truth");
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return options;
}

} // namespace princeton_benchmark
