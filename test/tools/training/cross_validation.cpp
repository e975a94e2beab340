// SPDX-License-Identifier: GPL-3.0-or-later

#include "cross_validation.h"

#include "merging_runs.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace train_merge_cost {

namespace {

/// Appends the rows of a run of a model and of its variants: `run(graph, seed)`, with a seed for
/// each run, model and variant.
template <typename Run>
void append_rows(Training_rows& rows, const Training_model& model, unsigned training_seed,
                 std::size_t run_number, const Run& run)
{
  const unsigned seed = training_seed * 1000000u + unsigned(run_number) * 1000u +
                        unsigned(model.number);
  const auto append = [&](const Training_graph& start, unsigned run_seed) {
    Training_rows more = run(start, run_seed);
    for (float& weight : more.weights)
      weight *= float(start.weight);
    rows.append(more);
  };
  append(model, seed);
  for (std::size_t i = 0; i < model.variants.size(); ++i)
    append(model.variants[i], seed + unsigned(i + 1) * 100000u);
}

std::size_t number_of(const Folds& folds)
{
  return 1 + *std::max_element(folds.begin(), folds.end());
}

/// All rows but those of the models of one fold.
Training_rows rows_without(const std::vector<Training_rows>& rows, const Folds& folds,
                           std::size_t fold)
{
  Training_rows result;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (folds[i] != fold)
      result.append(rows[i]);
  return result;
}

std::vector<Model> train_folds(const std::vector<Training_rows>& rows, const Folds& folds,
                               const Training_plan& plan)
{
  std::vector<Model> trained;
  for (std::size_t fold = 0; fold < number_of(folds); ++fold)
    trained.push_back(train_networks(rows_without(rows, folds, fold), plan.options, plan.seed));
  return trained;
}

/// The rows of runs by the hand-made cost, by model.
std::vector<Training_rows> first_rows(const std::vector<Training_model>& models,
                                      const Training_plan& plan)
{
  std::vector<Training_rows> rows(models.size());
  for (std::size_t i = 0; i < models.size(); ++i)
    for (std::size_t run = 0; run <= plan.noisy_runs; ++run)
      append_rows(
        rows[i], models[i], plan.seed, run, [&](const Training_graph& start, unsigned run_seed) {
          return rows_of_visibility_run(start, run > 0 ? plan.noise : 0, plan.share, run_seed);
        });
  return rows;
}

} // namespace

Folds folds_of_models(const std::vector<Training_model>& models, std::size_t number)
{
  std::map<std::string, std::size_t> pieces; // of other collections, by category
  for (const Training_model& model : models)
    if (model.collection != "benchmark")
      ++pieces[model.category];
  std::vector<std::pair<std::string, std::size_t>> categories(pieces.begin(), pieces.end());
  std::stable_sort(categories.begin(), categories.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::map<std::string, std::size_t> fold_of;
  std::vector<std::size_t> sizes(number);
  for (const auto& [category, size] : categories) {
    const auto fold = std::min_element(sizes.begin(), sizes.end());
    fold_of[category] = std::size_t(fold - sizes.begin());
    *fold += size;
  }
  Folds folds;
  std::size_t next = 0;
  for (const Training_model& model : models)
    folds.push_back(model.collection != "benchmark" ? fold_of.at(model.category) : next++ % number);
  return folds;
}

Folds folds_of_categories(const std::vector<Training_model>& models)
{
  Folds folds;
  std::map<std::string, std::size_t> fold_of;
  for (const Training_model& model : models)
    folds.push_back(fold_of.emplace(model.category, fold_of.size()).first->second);
  return folds;
}

Cross_validation cross_validate(const std::vector<Training_model>& models, const Folds& folds,
                                const Training_plan& plan)
{
  Cross_validation result{folds, {}, first_rows(models, plan)};
  result.trained = train_folds(result.rows, folds, plan);
  for (std::size_t round = 0; round < plan.learned_runs; ++round) {
    for (std::size_t i = 0; i < models.size(); ++i)
      append_rows(result.rows[i], models[i], plan.seed, plan.noisy_runs + 1 + round,
                  [&](const Training_graph& start, unsigned run_seed) {
                    return rows_of_learned_run(start, result.without(i), plan.share, run_seed);
                  });
    result.trained = train_folds(result.rows, folds, plan);
  }
  return result;
}

Training_rows all_rows(const Cross_validation& validation)
{
  Training_rows result;
  for (const Training_rows& rows : validation.rows)
    result.append(rows);
  return result;
}

Model train_on_all(const Cross_validation& validation, const Training_plan& plan)
{
  return train_networks(all_rows(validation), plan.options, plan.seed);
}

} // namespace train_merge_cost
