// SPDX-License-Identifier: GPL-3.0-or-later
//
// Learns from human segmentations how probable it is that two regions belong to one part, and
// writes the model as the header of the library that holds it. With scores: by cross-validation, a
// line of CSV for each comparison of a segmentation with that by a person.

#include "Network.h"
#include "Score.h"
#include "Training_model.h"
#include "Tree_distances.h"
#include "copies.h"
#include "cross_validation.h"
#include "field_copies.h"
#include "fingerprint.h"
#include "models.h"
#include "sheets.h"
#include "write_model.h"

#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace train_merge_cost {

namespace {

using princeton_benchmark::Copying;
using princeton_benchmark::Model_source;
using Method = Training_model::Method; // CGAL::Region_segmentation::Learned_merging

struct Options
{
  std::string data_folder, furniture_folder, header, name = "learned-3";
  bool has_scores = false;
  std::vector<Copying> variants = princeton_benchmark::variants();
  std::vector<Copying> field_copies = princeton_benchmark::field_copies();
  std::vector<std::size_t> draws;
  std::size_t folds = 5;
  double furniture_weight = 0.4; // 44 pieces weigh as 18 of the 190 models
  double sheet_weight = 0.2;     // 20 sheets weigh as 4
  Training_plan plan;
};

void add_options(CLI::App& app, Options& options)
{
  app.add_option("--data", options.data_folder, "The benchmark in its own layout")
    ->required()
    ->check(CLI::ExistingDirectory);
  app
    .add_option("--furniture", options.furniture_folder,
                "Learn from these models, too: KIND_NAME.off with the label of each face in "
                "KIND_NAME.seg")
    ->check(CLI::ExistingDirectory);
  app
    .add_option("--furniture-weight", options.furniture_weight,
                "Of such a model beside one of the benchmark")
    ->check(CLI::Range(0., 100.));
  app.add_option("--sheet-weight", options.sheet_weight, "Of a sheet, an open surface of one part")
    ->check(CLI::Range(0., 100.));
  app.add_option("--output", options.header, "Write the model as a header: learned_merge_model.h");
  app.add_option("--name", options.name,
                 "Of the model, with its version: each training has its own");
  app.add_flag(
    "--scores", options.has_scores,
    "Write CSV to stdout, for tables.py: the scores in sample, out of fold, of variants, "
    "and with categories left out");
  app.add_option("--draws", options.draws, "The scores with these numbers of draws, too")
    ->delimiter(',');
  app.add_option("--seed", options.plan.seed, "Of all that is random")->check(CLI::Range(1, 1000));
  app.add_flag_callback(
    "--no-variants",
    [&options] {
      options.variants.clear();
      options.field_copies.clear();
    },
    "Learn from the models alone, not from noisy, coarser, finer, open and assembled ones, too");
  app.add_option("--folds", options.folds, "Of the models, for cross-validation")
    ->check(CLI::Range(2, 1000));
}

/// A model of the benchmark, furniture, or a sheet.
struct Loaded
{
  Model_source source;
  princeton_benchmark::Model model;
};

std::vector<Loaded> load(const Options& options)
{
  std::vector<Loaded> result;
  for (const Model_source& source :
       princeton_benchmark::find_models(options.data_folder, options.furniture_folder))
    result.push_back({source, source.load()});
  for (princeton_benchmark::Sheet& sheet : princeton_benchmark::make_sheets(options.plan.seed)) {
    const int number = result.back().source.number + 1;
    result.push_back({{"sheet " + std::to_string(number), sheet.kind, number, "sheets", {}, {}, 1},
                      std::move(sheet.model)});
  }
  return result;
}

double weight_of(const Model_source& source, const Options& options)
{
  return source.collection == "furniture" ? options.furniture_weight
         : source.collection == "sheets"  ? options.sheet_weight
                                          : 1;
}

std::vector<Training_model> make_training_models(const std::vector<Loaded>& loaded,
                                                 const Options& options)
{
  std::vector<Training_model> models;
  for (std::size_t i = 0; i < loaded.size(); ++i) {
    const auto& [source, model] = loaded[i];
    const auto make = [&](const princeton_benchmark::Model& m) {
      Training_model result = make_training_model(source.number, m, Method());
      result.weight = weight_of(source, options);
      return result;
    };
    models.push_back(make(model));
    models.back().category = source.category;
    models.back().collection = source.collection;
    if (source.collection == "sheets")
      continue;
    std::vector<Copying> kinds = options.field_copies;
    for (std::size_t v = i % 2; v < options.variants.size(); v += 2) // half of them, which is
      kinds.push_back(options.variants[v]);                          // enough of each
    for (const Copying& kind : kinds)
      models.back().variants.push_back(make(copied(model, kind, unsigned(i))));
  }
  return models;
}

/// Writes the scores of a model as `Learned_merging` with what was learned.
void write_scores(const std::string& way, const Loaded& loaded, const Training_model& model,
                  const Method& method)
{
  const Tree_distances distances(model, method);
  const auto write = [&](const std::string& number, std::size_t segments) {
    for (std::size_t i = 0; i < model.people.size(); ++i)
      write_score(std::cout, loaded.source, loaded.model, {way, number, segments, 0}, i,
                  {distances(segments)[i]});
  };
  write("given", loaded.model.number_of_segments);
  write("chosen", distances.chosen_number());
  write("best", distances.best_number());
}

Method method_with(const Model& learned, std::size_t draws)
{
  Method method(learned);
  method.number_of_draws = draws;
  return method;
}

std::vector<Copying> all_kinds(const Options& options)
{
  std::vector<Copying> kinds = options.variants;
  kinds.insert(kinds.end(), options.field_copies.begin(), options.field_copies.end());
  return kinds;
}

/// Of the models in sample, out of fold, with other numbers of draws, of their variants (with
/// other seeds than those that are learned from), and with whole categories left out.
void write_all_scores(const Options& options, const std::vector<Loaded>& loaded,
                      const std::vector<Training_model>& models, const Cross_validation& validation,
                      const Model& trained)
{
  princeton_benchmark::write_header_of_scores(std::cout);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Model& without = validation.without(i);
    write_scores("in sample", loaded[i], models[i], Method(trained));
    write_scores("out of fold", loaded[i], models[i], Method(without));
    for (const std::size_t draws : options.draws)
      write_scores("out of fold (draws: " + std::to_string(draws) + ")", loaded[i], models[i],
                   method_with(without, draws));
    if (loaded[i].source.collection == "sheets") // of which a camera may see nothing
      continue;
    for (const Copying& variant : all_kinds(options)) {
      const princeton_benchmark::Model model = copied(loaded[i].model, variant,
                                                      unsigned(models.size() + i));
      write_scores("out of fold (" + variant.name + ")", {loaded[i].source, model},
                   make_training_model(loaded[i].source.number, model, Method()), Method(without));
    }
  }
  const Cross_validation by_category = cross_validate(models, folds_of_categories(models),
                                                      options.plan);
  for (std::size_t i = 0; i < models.size(); ++i)
    write_scores("category left out", loaded[i], models[i], Method(by_category.without(i)));
}

std::string in_digits(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string names_of(const std::vector<Copying>& kinds)
{
  std::string names;
  for (const Copying& kind : kinds)
    names += (&kind == &kinds.front() ? "" : ", ") + kind.name;
  return kinds.empty() ? "none" : names;
}

std::ptrdiff_t number_of(const std::vector<Training_model>& models, const std::string& collection)
{
  return std::count_if(models.begin(), models.end(),
                       [&](const Training_model& m) { return m.collection == collection; });
}

/// The models that were learned from, in words.
std::string names_of_models(const Options& options, const std::vector<Training_model>& models)
{
  const std::ptrdiff_t size = number_of(models, "benchmark"),
                       pieces = number_of(models, "furniture");
  const bool even = std::all_of(models.begin(), models.begin() + size,
                                [](const Training_model& m) { return m.number % 2 == 0; });
  std::string names = std::to_string(size) + " models of the Princeton Segmentation Benchmark, " +
                      (even ? "of its even-numbered half, number " : "number ") +
                      std::to_string(models.front().number) + " to " +
                      std::to_string(models[size - 1].number);
  if (pieces > 0)
    names += ", and " + std::to_string(pieces) + " pieces of furniture of the weight " +
             in_digits(options.furniture_weight);
  return names + ", and " + std::to_string(number_of(models, "sheets")) + " sheets of the weight " +
         in_digits(options.sheet_weight) + ".";
}

std::vector<std::string> provenance(const Options& options,
                                    const std::vector<Training_model>& models,
                                    const Training_rows& rows)
{
  return {
    "Made by train_merge_cost --seed " + std::to_string(options.plan.seed) +
      (options.variants.empty() ? " --no-variants" : "") + " from " +
      names_of_models(options, models),
    std::string("The benchmark: X. Chen, A. Golovinskiy, T. Funkhouser, \"A Benchmark for 3D Mesh "
                "Segmentation\", ACM Transactions on Graphics 28(3), 2009. ") +
      (number_of(models, "furniture") > 0
         ? "The furniture: made of the parts of IKEA-Manuals-at-Work (Liu et al., CC BY 4.0). "
         : "") +
      "See doc/accuracy.md.",
    "Variants of every other model: " + names_of(options.variants) +
      "; of every model: " + names_of(options.field_copies) + ".",
    "Hash of the " + std::to_string(rows.size()) + " training rows: " + fingerprint(rows) + "."};
}

void write_header(const std::string& file, const Model& trained,
                  const std::vector<std::string>& comment)
{
  std::ofstream out(file);
  write_model(out, trained, comment);
  if (!out.flush())
    throw std::runtime_error(file + " cannot be written");
}

int run_program(int argc, char** argv)
{
  Options options;
  CLI::App app("Trains the learned merge cost on a copy of the Princeton Segmentation Benchmark.",
               "train_merge_cost");
  add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  const std::vector<Loaded> loaded = load(options);
  const std::vector<Training_model> models = make_training_models(loaded, options);
  const Cross_validation validation = cross_validate(models, folds_of_models(models, options.folds),
                                                     options.plan);
  Model trained = train_on_all(validation, options.plan);
  trained.name = options.name;
  if (!options.header.empty())
    write_header(options.header, trained, provenance(options, models, all_rows(validation)));
  if (options.has_scores)
    write_all_scores(options, loaded, models, validation, trained);
  return 0;
}

} // namespace

} // namespace train_merge_cost

int main(int argc, char** argv)
{
  try {
    return train_merge_cost::run_program(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "train_merge_cost: " << error.what() << "\n";
    return 1;
  }
}
