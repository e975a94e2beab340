// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares segmentations of the models of the Princeton Segmentation Benchmark, and of furniture,
// with those by people: a line of CSV for each comparison.

#include "Score.h"
#include "methods.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <ctime>
#include <exception>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace princeton_benchmark {

namespace {

struct Options
{
  std::string data_folder, furniture_folder;
  std::vector<std::string> methods = {"people", "learned", "visibility", "two-step"};
  std::size_t draws = 0, step = 1, runs = 1;
};

double processor_seconds()
{
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// Each person against the others.
void score_people(const Model_source& source, const Model& model)
{
  const Mesh mesh = make_mesh(model.soup);
  for (std::size_t i = 0; i < model.people.size(); ++i)
    for (std::size_t j = 0; j < model.people.size(); ++j)
      if (i != j)
        write_score(std::cout, source, model,
                    {"people", std::to_string(i), model.people[i].number_of_segments, 0}, j,
                    compare(mesh, model.people[i].labels, model.people[j]));
}

void score_method(const Model_source& source, const Model& model, const std::string& way,
                  const Method& method, std::size_t runs)
{
  const Mesh mesh = make_mesh(model.soup);
  std::vector<int> labels(num_faces(mesh));
  const auto score = [&](const std::string& number, std::optional<std::size_t> wanted) {
    Segmentation segmentation{way, number, 0, 1e9};
    for (std::size_t run = 0; run < runs; ++run) {
      const double start = processor_seconds();
      segmentation.number_of_segments = method.segment(mesh, wanted, labels);
      segmentation.seconds = (std::min)(segmentation.seconds, processor_seconds() - start);
    }
    for (std::size_t i = 0; i < model.people.size(); ++i)
      write_score(std::cout, source, model, segmentation, i,
                  compare(mesh, labels, model.people[i]));
  };
  if (method.takes_number)
    score("given", model.number_of_segments);
  if (method.chooses_number)
    score("chosen", std::nullopt);
}

void score_model(const Model_source& source, const Options& options)
{
  static const std::map<std::string, Method> all = methods(options.draws);
  const Model model = source.load();
  for (const std::string& name : options.methods)
    if (name == "people")
      score_people(source, model);
    else
      score_method(source, model,
                   name +
                     (options.draws > 0 ? " (draws: " + std::to_string(options.draws) + ")" : ""),
                   all.at(name), options.runs);
}

/// The exit status. A model that fails is told of; the others are still scored.
int score_models(const Options& options)
{
  int status = 0;
  const auto sources = find_models(options.data_folder, options.furniture_folder);
  write_header_of_scores(std::cout);
  for (std::size_t i = 0; i < sources.size(); i += options.step)
    try {
      score_model(sources[i], options);
    } catch (const std::exception& error) {
      std::cerr << "princeton_benchmark: model " << sources[i].name << ": " << error.what() << "\n";
      status = 1;
    }
  return status;
}

int run_program(int argc, char** argv)
{
  Options options;
  CLI::App app("Compares segmentations with those by people. Writes CSV to stdout, for tables.py.",
               "princeton_benchmark");
  app.add_option("--data", options.data_folder, "The benchmark in its own layout")
    ->required()
    ->check(CLI::ExistingDirectory);
  app.add_option("--furniture", options.furniture_folder, "KIND_NAME.off with KIND_NAME.seg, too")
    ->check(CLI::ExistingDirectory);
  app
    .add_option("--methods", options.methods,
                "people (each against the others), learned, visibility, two-step, "
                "concave-angles (as MeshLib), sdf (CGAL's)")
    ->delimiter(',')
    ->check(
      CLI::IsMember({"people", "learned", "visibility", "two-step", "concave-angles", "sdf"}));
  app.add_option("--draws", options.draws, "Of learned and visibility")->check(CLI::Range(1, 1000));
  app.add_option("--every", options.step, "One of so many models")->check(CLI::Range(1, 1000));
  app.add_option("--runs", options.runs, "Of which the least time is written")
    ->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  return score_models(options);
}

} // namespace

} // namespace princeton_benchmark

int main(int argc, char** argv)
{
  try {
    return princeton_benchmark::run_program(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "princeton_benchmark: " << error.what() << "\n";
    return 1;
  }
}
