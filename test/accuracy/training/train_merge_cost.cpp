// SPDX-License-Identifier: GPL-3.0-or-later
//
// Learns from human segmentations how probable it is that two regions belong to one part, and writes the model as the
// header of the library that holds it. With a report: cross-validation, calibration, importance of features.

#include "Princeton_data.h"
#include "Trained_model.h"
#include "Training_model.h"
#include "cross_validation.h"
#include "fingerprint.h"
#include "model_sources.h"
#include "model_variants.h"
#include "training_report.h"
#include "training_sources_hash.h"
#include "write_model.h"

#include "io/Whole_file.h"
#include "io/errors.h"

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Superfacets.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <iostream>
#include <numeric>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace train_merge_cost {

namespace {

/// Of each model, to learn from: `superfacets` times as many first regions, each face split into four `subdivisions` times.
struct Variant
{
  double superfacets;
  std::size_t subdivisions;
};

struct Options
{
  std::string data_folder, header;
  bool has_report = false;
  std::size_t superfacets = CGAL::Region_segmentation::Superfacets().number;
  std::size_t few = CGAL::Region_segmentation::Learned_merging::few;
  std::vector<Variant> variants = {{11. / 12, 0}, {13. / 12, 0}, {1, 1}};
  std::size_t folds = 5, subdivisions = 0;
  Training_plan plan;
};

std::variant<Options, int> parse_command_line(int argc, char** argv)
{
  Options options;
  CLI::App app("Trains the learned merge cost on a copy of the Princeton Segmentation Benchmark.", "train_merge_cost");
  app.add_option("--data", options.data_folder, "The benchmark in its own layout")
    ->required()
    ->check(CLI::ExistingDirectory)
    ->type_name("DIR");
  app.add_option("--output", options.header, "Write the model as a header: learned_merge_model.h")->type_name("FILE");
  app.add_flag("--report", options.has_report,
               "Categories left out, calibration and the importance of features, too");
  app.add_option("--seed", options.plan.seed, "Of all that is random. Default: 1")->check(CLI::Range(1, 1000));
  app.add_option("--trainings", options.plan.trainings, "Whose mean is the model. Default: 1")->check(CLI::Range(1, 100));
  app.add_option("--superfacets", options.superfacets, "First regions. Default: that of Superfacets")->check(CLI::Range(1, 100000));
  app.add_option("--few", options.few, "Regions from which on the model merges. Default: that of Learned_merging")
    ->check(CLI::Range(2, 100000));
  app.add_flag_callback("--no-variants", [&options] { options.variants.clear(); },
                        "Learn from the models alone, not from finer ones and other superfacets, too");
  app.add_option("--folds", options.folds, "Of the models, for cross-validation. Default: 5")->check(CLI::Range(2, 1000));
  app.add_option("--subdivisions", options.subdivisions,
                 "Score the models with each face split into four so often, too, out of fold")
    ->check(CLI::Range(1, 5));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return options;
}

/// The same model with each face split into four.
princeton_benchmark::Model split_into_four(princeton_benchmark::Model model)
{
  segment_mesh::Labelled_model faces;
  faces.soup = std::move(model.soup);
  faces.labels.resize(faces.soup.polygons.size());
  std::iota(faces.labels.begin(), faces.labels.end(), std::size_t(0));
  segment_mesh::Labelled_model split = princeton_benchmark::split_into_four(faces);
  model.soup = std::move(split.soup);
  for (princeton_benchmark::Truth& truth : model.truths) {
    std::vector<int> labels;
    for (const std::size_t face : split.labels)
      labels.push_back(truth.labels[face]);
    truth.labels = std::move(labels);
  }
  return model;
}

princeton_benchmark::Model subdivided(princeton_benchmark::Model model, std::size_t times)
{
  for (std::size_t i = 0; i < times; ++i)
    model = split_into_four(std::move(model));
  return model;
}

std::size_t superfacets_of(const Variant& variant, const Options& options)
{
  return std::size_t(std::llround(variant.superfacets * double(options.superfacets)));
}

std::vector<Training_model> load_models(const Princeton_data& data, const Options& options)
{
  std::vector<Training_model> models;
  const auto sources = princeton_benchmark::princeton_sources(data);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const princeton_benchmark::Model model = sources[i].load();
    models.push_back(make_training_model(data.models()[i], model, options.superfacets, options.few));
    for (const Variant& variant : options.variants)
      models.back().variants.push_back(make_training_model(data.models()[i], subdivided(model, variant.subdivisions),
                                                           superfacets_of(variant, options), options.few));
  }
  return models;
}

/// Out of fold; one after the other, since they are large.
std::vector<Model_score> scores_of_subdivided(const Princeton_data& data, const Options& options,
                                              const Cross_validation& validation)
{
  std::vector<Model_score> scores;
  const auto sources = princeton_benchmark::princeton_sources(data);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const princeton_benchmark::Model model = subdivided(sources[i].load(), options.subdivisions);
    scores.push_back(score_learned(make_training_model(data.models()[i], model, options.superfacets, options.few),
                                   validation.without(i)));
  }
  return scores;
}

template <typename Score>
std::vector<Model_score> scores_of(const std::vector<Training_model>& models, const Score& score)
{
  std::vector<Model_score> scores;
  for (std::size_t i = 0; i < models.size(); ++i)
    scores.push_back(score(models[i]));
  return scores;
}

std::string mean_given_and_chosen(const std::vector<Model_score>& scores)
{
  double given = 0, chosen = 0;
  for (const Model_score& score : scores) {
    given += score.given / double(scores.size());
    chosen += score.automatic / double(scores.size());
  }
  char text[64];
  std::snprintf(text, sizeof text, "%.4f / %.4f", given, chosen);
  return text;
}

std::string names_of_variants(const Options& options)
{
  std::string names = "With " + std::to_string(options.superfacets) + " superfacets; variants: ";
  for (const Variant& variant : options.variants)
    names += (&variant == &options.variants.front() ? "" : ", ") + std::to_string(superfacets_of(variant, options)) +
             " superfacets of faces split " + std::to_string(variant.subdivisions) + " times";
  return names + (options.variants.empty() ? "none." : ".");
}

std::vector<std::string> provenance(const Options& options, const std::vector<Training_model>& models,
                                    const Cross_validation& validation)
{
  const Training_rows rows = all_rows(validation);
  return {"Made by train_merge_cost --seed " + std::to_string(options.plan.seed) + " --trainings " +
            std::to_string(options.plan.trainings) + (options.variants.empty() ? " --no-variants" : "") + " from " +
            std::to_string(models.size()) + " models of the Princeton Segmentation Benchmark, number " +
            std::to_string(models.front().number) + " to " + std::to_string(models.back().number) + ".",
          names_of_variants(options),
          "Hash of the " + std::to_string(rows.size()) + " training rows: " + fingerprint(rows) +
            "; of the training sources: " + std::string(training_sources_hash) + ".",
          "1 - Rand index, out of fold, k given / chosen: " + mean_given_and_chosen(validation.scores) + "."};
}

void write_report(const Options& options, const std::vector<Training_model>& models,
                  const Cross_validation& validation, const Trained_model& final_model)
{
  const std::vector<Model_score> by_hand = scores_of(models, score_visibility);
  const Model model = final_model.model();
  const std::vector<Model_score> in_sample =
    scores_of(models, [&](const Training_model& m) { return score_learned(m, model); });
  std::vector<Scored_way> ways = {{"hand-made", &by_hand}, {"in sample", &in_sample}, {"out of fold", &validation.scores}};
  std::vector<Model_score> subdivided;
  if (options.subdivisions > 0) {
    subdivided = scores_of_subdivided(Princeton_data(options.data_folder), options, validation);
    ways.push_back({"out of fold, subdivided", &subdivided});
  }
  std::vector<Model_score> by_category;
  if (options.has_report) {
    by_category = cross_validate(models, folds_of_categories(models), options.plan).scores;
    ways.push_back({"category left out", &by_category});
  }
  using princeton_benchmark::write_text;
  write_text(std::cout, means_table(ways));
  if (options.subdivisions > 0)
    write_text(std::cout, differences_table(validation.scores, subdivided));
  if (!options.has_report)
    return;
  write_text(std::cout, category_table(models, ways));
  write_text(std::cout, calibration_table(validation));
  write_text(std::cout, importance_table(validation, options.plan.seed));
}

int run_program(int argc, char** argv)
{
  const auto parsed = parse_command_line(argc, argv);
  if (const int* exit_status = std::get_if<int>(&parsed))
    return *exit_status;
  const Options& options = std::get<Options>(parsed);
  const Princeton_data data(options.data_folder);
  const std::vector<Training_model> models = load_models(data, options);
  const Cross_validation validation =
    cross_validate(models, folds_of_models(models, options.folds), options.plan);
  const Trained_model trained = train_on_all(validation, options.plan);
  write_report(options, models, validation, trained);
  if (!options.header.empty()) {
    segment_mesh::Whole_file file(options.header);
    write_model(file.stream(), trained, provenance(options, models, validation));
    file.commit();
  }
  return 0;
}

} // namespace

} // namespace train_merge_cost

int main(int argc, char** argv)
{
  try {
    return train_merge_cost::run_program(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "train_merge_cost: " << segment_mesh::one_line(error.what()) << "\n";
    return 1;
  }
}
