// SPDX-License-Identifier: GPL-3.0-or-later

#include "cross_validation.h"

#include "Princeton_data.h"
#include "merging_runs.h"

#include <algorithm>
#include <map>

namespace train_merge_cost {

namespace {

/// A seed for each model and run.
unsigned seed_of(const Training_plan& plan, std::size_t run, const Training_model& model)
{
  return plan.seed * 1000000u + unsigned(run) * 1000u + unsigned(model.number);
}

std::size_t number_of(const Folds& folds)
{
  return 1 + *std::max_element(folds.begin(), folds.end());
}

std::vector<Trained_model> train_folds(const std::vector<Training_rows>& rows, const Folds& folds,
                                       const Training_plan& plan)
{
  std::vector<Trained_model> trained;
  for (std::size_t fold = 0; fold < number_of(folds); ++fold)
    trained.push_back(train(rows_without(rows, folds, fold), plan.options, plan.seed));
  return trained;
}

} // namespace

Folds folds_of_models(const std::vector<Training_model>& models, std::size_t number)
{
  Folds folds;
  for (std::size_t i = 0; i < models.size(); ++i)
    folds.push_back(i % number);
  return folds;
}

Folds folds_of_categories(const std::vector<Training_model>& models)
{
  Folds folds;
  std::map<int, std::size_t> fold_of;
  for (const Training_model& model : models)
    folds.push_back(fold_of.emplace(Princeton_data::category(model.number), fold_of.size()).first->second);
  return folds;
}

std::vector<Training_rows> first_rows(const std::vector<Training_model>& models, const Training_plan& plan)
{
  std::vector<Training_rows> rows;
  for (const Training_model& model : models) {
    rows.push_back(rows_of_visibility_run(model, 0, plan.share, seed_of(plan, 0, model)));
    for (std::size_t run = 1; run <= plan.noisy_runs; ++run)
      rows.back().append(rows_of_visibility_run(model, plan.noise, plan.share, seed_of(plan, run, model)));
  }
  return rows;
}

Cross_validation cross_validate(const std::vector<Training_model>& models, const std::vector<Training_rows>& first_rows,
                                const Folds& folds, const Training_plan& plan)
{
  Cross_validation result{folds, train_folds(first_rows, folds, plan), first_rows, {}};
  for (std::size_t round = 0; round < plan.learned_runs; ++round) {
    for (std::size_t i = 0; i < models.size(); ++i)
      result.rows[i].append(rows_of_learned_run(models[i], result.without(i), plan.share,
                                                seed_of(plan, plan.noisy_runs + 1 + round, models[i])));
    result.trained = train_folds(result.rows, folds, plan);
  }
  for (std::size_t i = 0; i < models.size(); ++i)
    result.scores.push_back(score_learned(models[i], result.without(i)));
  return result;
}

Training_rows rows_without(const std::vector<Training_rows>& rows, const Folds& folds, std::size_t fold)
{
  Training_rows result;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (folds[i] != fold)
      result.append(rows[i]);
  return result;
}

Training_rows joined(const std::vector<Training_rows>& rows)
{
  Training_rows result;
  for (const Training_rows& each : rows)
    result.append(each);
  return result;
}

} // namespace train_merge_cost
