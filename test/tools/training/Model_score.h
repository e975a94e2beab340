// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_MODEL_SCORE_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_MODEL_SCORE_H

#include "Training_model.h"
#include "Training_rows.h"

#include <cstddef>
#include <vector>

namespace train_merge_cost {

/// Rand index distances between what `segment()` gives and the segmentations by people.
struct Model_score
{
  double given = 0;              ///< with k of the standard protocol, mean over the people
  double automatic = 0;          ///< with the chosen number
  double best = 0;               ///< with the best number of the tree in hindsight
  double nearest = 0, first = 0; ///< the paper's protocol; NaN if no person has the number k
  std::size_t chosen_number = 0;
};

/// As `Learned_merging` with a model.
Model_score score_learned(const Training_model& model, const Model& learned);

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_MODEL_SCORE_H
