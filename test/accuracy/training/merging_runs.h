// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_ACCURACY_TRAINING_MERGING_RUNS_H
#define CGAL_REGION_SEGMENTATION_TEST_ACCURACY_TRAINING_MERGING_RUNS_H

#include "Training_model.h"
#include "Training_rows.h"

#include <cstddef>
#include <vector>

namespace train_merge_cost {

/// The candidates met while the hand-made cost merges a model; each is taken with the probability `share`.
/// `noise`: the standard deviation of a random number that is added to the cost.
Training_rows rows_of_visibility_run(const Training_model& model, double noise, double share, unsigned seed);

/// The candidates met while a learned cost merges a model; each is taken with the probability `share`.
Training_rows rows_of_learned_run(const Training_model& model, const Model& learned, double share, unsigned seed);

/// Rand index distances to the segmentations by people.
struct Model_score
{
  double given = 0;     ///< with k of the standard protocol, mean over the people
  double automatic = 0; ///< with the chosen number; NaN where none is chosen
  double best = 0;      ///< with the best number of the tree in hindsight
  double nearest = 0, first = 0; ///< the paper's protocol; NaN if no person has the number k
  std::size_t chosen_number = 0;
  std::vector<double> distances; ///< by number of segments, from 0; mean over the people; the first are those of 1 or of the least number
};

/// Merges a model by a learned cost, and chooses the number as the method does.
Model_score score_learned(const Training_model& model, const Model& learned);

/// The same by the hand-made cost, without a chosen number.
Model_score score_visibility(const Training_model& model);

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_ACCURACY_TRAINING_MERGING_RUNS_H
