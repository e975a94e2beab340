// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TRAINING_REPORT_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TRAINING_REPORT_H

#include "Table.h"
#include "cross_validation.h"

#include <string>
#include <vector>

namespace train_merge_cost {

/// The scores of all models in one way.
struct Scored_way
{
  std::string name;
  const std::vector<Model_score>* scores;
};

/// Means over the models of the benchmark, and over those of furniture, with the standard error of
/// the mean.
princeton_benchmark::Table means_table(const std::vector<Training_model>& models,
                                       const std::vector<Scored_way>& ways);

/// Means over the models of each category, k given and chosen.
princeton_benchmark::Table category_table(const std::vector<Training_model>& models,
                                          const std::vector<Scored_way>& ways);

/// Out of fold: what was predicted, and what people say.
princeton_benchmark::Table calibration_table(const Cross_validation& validation);

/// Out of fold: how much the loss grows where the values of a feature are exchanged between rows at
/// random.
princeton_benchmark::Table importance_table(const Cross_validation& validation, unsigned seed);

/// The mean loss of a row, in nats: that of the logarithmic score over the entropy of what people
/// say. 0 is perfect.
double mean_loss(const Cross_validation& validation);

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TRAINING_REPORT_H
