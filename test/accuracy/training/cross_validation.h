// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_ACCURACY_TRAINING_CROSS_VALIDATION_H
#define CGAL_REGION_SEGMENTATION_TEST_ACCURACY_TRAINING_CROSS_VALIDATION_H

#include "Model_score.h"
#include "Trained_model.h"
#include "Training_model.h"
#include "Training_rows.h"

#include <cstddef>
#include <vector>

namespace train_merge_cost {

/// Which candidates are learned from, and how.
struct Training_plan
{
  unsigned seed = 1;
  std::size_t noisy_runs = 3;         ///< of the hand-made cost, in addition to one without noise
  double noise = 1.5;                 ///< standard deviation
  std::size_t learned_runs = 1;       ///< rounds in which models are merged by what was learned without them
  double share = 0.5;                 ///< of the candidates of a run
  Training_options options;
};

/// The fold of every model. Models of one fold are scored by a model that was trained on the others.
using Folds = std::vector<std::size_t>;

/// `number` folds; neighbors in the benchmark, which are of one category, belong to different ones.
Folds folds_of_models(const std::vector<Training_model>& models, std::size_t number);

/// A fold for each category that is there.
Folds folds_of_categories(const std::vector<Training_model>& models);

/// The rows of runs by the hand-made cost, by model.
std::vector<Training_rows> first_rows(const std::vector<Training_model>& models, const Training_plan& plan);

struct Cross_validation
{
  Folds folds;
  std::vector<Trained_model> trained; ///< by fold, without it
  std::vector<Training_rows> rows;    ///< by model: those that were trained on
  std::vector<Model_score> scores;    ///< by model, out of fold

  /// The model that was trained without a model of the benchmark.
  Model without(std::size_t model) const { return trained[folds[model]].model(); }
};

/// Rounds of training, each on the rows of all earlier ones; the scores are those of the last one.
Cross_validation cross_validate(const std::vector<Training_model>& models, const std::vector<Training_rows>& first_rows,
                                const Folds& folds, const Training_plan& plan);

/// All rows but those of the models of one fold.
Training_rows rows_without(const std::vector<Training_rows>& rows, const Folds& folds, std::size_t fold);

/// All rows.
Training_rows joined(const std::vector<Training_rows>& rows);

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_ACCURACY_TRAINING_CROSS_VALIDATION_H
