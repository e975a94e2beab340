// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_CROSS_VALIDATION_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_CROSS_VALIDATION_H

#include "Network.h"
#include "Training_model.h"
#include "Training_rows.h"

#include <cstddef>
#include <vector>

namespace train_merge_cost {

/// Which candidates are learned from, and how.
struct Training_plan
{
  unsigned seed = 1;            ///< at least 1
  std::size_t noisy_runs = 3;   ///< of the hand-made cost, in addition to one without noise
  double noise = 1.5;           ///< standard deviation
  std::size_t learned_runs = 1; ///< rounds in which models are merged by what was learned without
                                ///< them
  double share = 0.3;           ///< of the candidates of a run
  Network_options options;
};

/// The fold of every model. Models of one fold are scored by a model that was trained on the
/// others.
using Folds = std::vector<std::size_t>;

/// `number` folds. Neighbors in the benchmark, which are of one category, belong to different ones.
/// Furniture or sheets of one category belong to one: the largest category first, each to the fold
/// that has the fewest of these.
Folds folds_of_models(const std::vector<Training_model>& models, std::size_t number);

/// A fold for each category that is there, whatever the collection.
Folds folds_of_categories(const std::vector<Training_model>& models);

struct Cross_validation
{
  Folds folds;
  std::vector<Model> trained;      ///< by fold, without it
  std::vector<Training_rows> rows; ///< by model: those that were trained on

  /// The model that was trained without one of the models.
  const Model& without(std::size_t model) const { return trained[folds[model]]; }
};

/// Training consists of rounds, each on the rows of all earlier ones.
Cross_validation cross_validate(const std::vector<Training_model>& models, const Folds& folds,
                                const Training_plan& plan);

/// The rows of all models.
Training_rows all_rows(const Cross_validation& validation);

Model train_on_all(const Cross_validation& validation, const Training_plan& plan);

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_CROSS_VALIDATION_H
