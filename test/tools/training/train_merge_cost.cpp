// SPDX-License-Identifier: GPL-3.0-or-later
//
// Learns from human segmentations how probable it is that two regions belong to one part, and
// writes the model as the header of the library that holds it. With a report: cross-validation,
// calibration, importance of features.

#include "Network.h"
#include "Princeton_data.h"
#include "Training_model.h"
#include "cross_validation.h"
#include "decimated.h"
#include "fingerprint.h"
#include "model_sources.h"
#include "model_variants.h"
#include "training_report.h"
#include "training_sources_hash.h"
#include "write_model.h"

#include "read/errors.h"
#include "write/Whole_file.h"

#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>

#include <CLI/CLI.hpp>

#include <algorithm>
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

using segment_mesh::Labelled_model;

/// What is learned from in addition to every other model: the same with other faces, whose labels
/// are those of the faces that they come from.
struct Variant
{
  std::string name;
  Labelled_model (*change)(Labelled_model model, unsigned seed);
};

std::vector<Variant> variants_of_models()
{
  using namespace princeton_benchmark;
  return {
    {"faces split into four",
     [](Labelled_model model, unsigned) { return split_into_four(model); }},
    {"noise of 1/8 of the mean edge",
     [](Labelled_model model, unsigned seed) {
       return with_noise(std::move(model), 1. / 8, seed);
     }},
    {"noise of 1/16 of the mean edge",
     [](Labelled_model model, unsigned seed) {
       return with_noise(std::move(model), 1. / 16, seed);
     }},
    {"a tenth of the edges", [](Labelled_model model, unsigned) { return decimated(model, 0.1); }},
    {"half of the edges", [](Labelled_model model, unsigned) { return decimated(model, 0.5); }},
    {"holes of 1 % of the faces",
     [](Labelled_model model, unsigned seed) { return with_holes(model, 0.01, seed); }}};
}

struct Options
{
  std::string data_folder, furniture_folder, header, name = "learned-2";
  bool has_report = false;
  std::vector<Variant> variants = variants_of_models();
  std::size_t folds = 5;
  double furniture_weight = 0.4; // 44 pieces weigh as 18 of the 190 models
  Training_plan plan;
};

std::variant<Options, int> parse_command_line(int argc, char** argv)
{
  Options options;
  CLI::App app("Trains the learned merge cost on a copy of the Princeton Segmentation Benchmark.",
               "train_merge_cost");
  app.add_option("--data", options.data_folder, "The benchmark in its own layout")
    ->required()
    ->check(CLI::ExistingDirectory)
    ->type_name("DIR");
  app
    .add_option("--furniture", options.furniture_folder,
                "Learn from these models, too: KIND_NAME.off with the label of each face in "
                "KIND_NAME.seg")
    ->check(CLI::ExistingDirectory)
    ->type_name("DIR");
  app
    .add_option("--furniture-weight", options.furniture_weight,
                "Of such a model beside one of the benchmark. Default: .4")
    ->check(CLI::Range(0., 100.));
  app.add_option("--output", options.header, "Write the model as a header: learned_merge_model.h")
    ->type_name("FILE");
  app
    .add_option("--name", options.name,
                "Of the model, with its version: each training has its own. Default: learned-2")
    ->type_name("NAME");
  app.add_flag("--report", options.has_report,
               "Variants, categories left out, calibration and the importance of features, too");
  app.add_option("--seed", options.plan.seed, "Of all that is random. Default: 1")
    ->check(CLI::Range(1, 1000));
  app.add_flag_callback(
    "--no-variants", [&options] { options.variants.clear(); },
    "Learn from the models alone, not from noisy, coarser, finer and open ones, too");
  app.add_option("--folds", options.folds, "Of the models, for cross-validation. Default: 5")
    ->check(CLI::Range(2, 1000));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return options;
}

/// The same model with other faces.
princeton_benchmark::Model changed(princeton_benchmark::Model model, const Variant& variant,
                                   unsigned seed)
{
  Labelled_model faces;
  faces.soup = std::move(model.soup);
  faces.labels.resize(faces.soup.polygons.size());
  std::iota(faces.labels.begin(), faces.labels.end(), std::size_t(0));
  Labelled_model result = variant.change(std::move(faces), seed);
  model.soup = std::move(result.soup);
  for (princeton_benchmark::Truth& truth : model.truths) {
    std::vector<int> labels;
    for (const std::size_t face : result.labels)
      labels.push_back(truth.labels[face]);
    truth.labels = std::move(labels);
  }
  return model;
}

/// A model that is learned from.
struct Source
{
  princeton_benchmark::Model_source model;
  int number; ///< of `Training_model`
  bool is_furniture;
};

/// `data` must exist as long as the result.
std::vector<Source> make_sources(const Princeton_data& data, const Options& options)
{
  constexpr int first_of_furniture = 20 * Princeton_data::number_of_categories + 1;
  std::vector<Source> sources;
  for (princeton_benchmark::Model_source& model : princeton_benchmark::princeton_sources(data))
    sources.push_back({std::move(model), data.models()[sources.size()], false});
  if (options.furniture_folder.empty())
    return sources;
  const std::size_t of_benchmark = sources.size();
  for (princeton_benchmark::Model_source& model :
       princeton_benchmark::furniture_sources(options.furniture_folder))
    sources.push_back(
      {std::move(model), first_of_furniture + int(sources.size() - of_benchmark), true});
  return sources;
}

std::vector<Training_model> load_models(const std::vector<Source>& sources, const Options& options)
{
  std::vector<Training_model> models;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const princeton_benchmark::Model model = sources[i].model.load();
    models.push_back(make_training_model(sources[i].number, model, Training_model::Method()));
    models.back().category = sources[i].model.category;
    models.back().is_furniture = sources[i].is_furniture;
    models.back().weight = sources[i].is_furniture ? options.furniture_weight : 1;
    for (std::size_t v = i % 2; v < options.variants.size(); v += 2) // half of them, which is
                                                                     // enough of each
      models.back().variants.push_back(
        make_training_model(sources[i].number, changed(model, options.variants[v], unsigned(i)),
                            Training_model::Method()));
  }
  return models;
}

/// Out of fold; with another seed than those that are learned from.
std::vector<Model_score> scores_of_variant(const std::vector<Source>& sources,
                                           const Variant& variant,
                                           const Cross_validation& validation)
{
  std::vector<Model_score> scores;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const princeton_benchmark::Model model = changed(sources[i].model.load(), variant,
                                                     unsigned(sources.size() + i));
    scores.push_back(
      score_learned(make_training_model(sources[i].number, model, Training_model::Method()),
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

std::size_t number_of_pieces(const std::vector<Training_model>& models)
{
  return std::size_t(std::count_if(models.begin(), models.end(),
                                   [](const Training_model& model) { return model.is_furniture; }));
}

std::string mean_given_and_chosen(const std::vector<Training_model>& models, bool of_furniture,
                                  const std::vector<Model_score>& scores)
{
  double given = 0, chosen = 0, number = 0;
  for (std::size_t i = 0; i < models.size(); ++i)
    if (models[i].is_furniture == of_furniture) {
      given += scores[i].given;
      chosen += scores[i].automatic;
      ++number;
    }
  return princeton_benchmark::score(given / number) + " / " +
         princeton_benchmark::score(chosen / number);
}

std::string in_digits(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string names_of_variants(const Options& options)
{
  std::string names = "Variants, each of every other model: ";
  for (const Variant& variant : options.variants)
    names += (&variant == &options.variants.front() ? "" : ", ") + variant.name;
  return names + (options.variants.empty() ? "none." : ".");
}

std::vector<std::string> provenance(const Options& options,
                                    const std::vector<Training_model>& models,
                                    const Cross_validation& validation)
{
  const Training_rows rows = all_rows(validation);
  const std::size_t pieces = number_of_pieces(models), of_benchmark = models.size() - pieces;
  const bool even = std::all_of(models.begin(), models.begin() + std::ptrdiff_t(of_benchmark),
                                [](const Training_model& m) { return m.number % 2 == 0; });
  const auto scores = [&](bool of_furniture) {
    return mean_given_and_chosen(models, of_furniture, validation.scores);
  };
  return {
    "Made by train_merge_cost --seed " + std::to_string(options.plan.seed) +
      (options.variants.empty() ? " --no-variants" : "") + " from " + std::to_string(of_benchmark) +
      " models of the Princeton Segmentation Benchmark, " +
      (even ? "of its even-numbered half, number " : "number ") +
      std::to_string(models.front().number) + " to " +
      std::to_string(models[of_benchmark - 1].number) +
      (pieces > 0 ? ", and " + std::to_string(pieces) + " pieces of furniture of the weight " +
                      in_digits(options.furniture_weight) + "."
                  : "."),
    std::string("The benchmark: X. Chen, A. Golovinskiy, T. Funkhouser, \"A Benchmark for 3D Mesh "
                "Segmentation\", ACM Transactions on Graphics 28(3), 2009. ") +
      (pieces > 0 ? "The furniture: made of the parts of IKEA-Manuals-at-Work (Liu et al., "
                    "CC BY 4.0). "
                  : "") +
      "See doc/accuracy.md.",
    names_of_variants(options),
    "Hash of the " + std::to_string(rows.size()) + " training rows: " + fingerprint(rows) +
      "; of the training sources: " + std::string(training_sources_hash) + ".",
    "1 - Rand index, out of fold, k given / chosen: " + scores(false) +
      (pieces > 0 ? "; of furniture: " + scores(true) : "") + "."};
}

/// Of the models, and with a report of their variants and with whole categories left out, each as
/// soon as it is known.
void write_report(const Options& options, const std::vector<Source>& sources,
                  const std::vector<Training_model>& models, const Cross_validation& validation,
                  const Model& final_model)
{
  using princeton_benchmark::write_text;
  const std::vector<Model_score> in_sample = scores_of(
    models, [&](const Training_model& m) { return score_learned(m, final_model); });
  std::vector<Scored_way> ways = {{"in sample", &in_sample}, {"out of fold", &validation.scores}};
  write_text(std::cout, means_table(models, ways));
  std::cout.flush();
  if (!options.has_report)
    return;
  for (const Variant& variant : options.variants) {
    const std::vector<Model_score> scores = scores_of_variant(sources, variant, validation);
    write_text(std::cout, means_table(models, {{"out of fold, " + variant.name, &scores}}));
    std::cout.flush();
  }
  const std::vector<Model_score>
    by_category = cross_validate(models, folds_of_categories(models), options.plan).scores;
  ways.push_back({"category left out", &by_category});
  write_text(std::cout, means_table(models, {ways.back()}));
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
  const std::vector<Source> sources = make_sources(data, options);
  const std::vector<Training_model> models = load_models(sources, options);
  const Cross_validation validation = cross_validate(models, folds_of_models(models, options.folds),
                                                     options.plan);
  Model trained = train_on_all(validation, options.plan);
  trained.name = options.name;
  if (!options.header.empty()) {
    segment_mesh::Whole_file file(options.header);
    write_model(file.stream(), trained, provenance(options, models, validation));
    file.commit();
  }
  write_report(options, sources, models, validation, trained);
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
