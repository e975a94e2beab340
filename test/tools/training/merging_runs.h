// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_MERGING_RUNS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_MERGING_RUNS_H

#include "Training_model.h"
#include "Training_rows.h"

#include <cstddef>
#include <vector>

namespace train_merge_cost {

/// The candidates met while the hand-made cost merges regions; each is taken with the probability
/// `share`. `noise`: the standard deviation of a random number that is added to the cost.
Training_rows rows_of_visibility_run(const Training_graph& start, double noise, double share,
                                     unsigned seed);

/// The candidates met while a learned cost merges regions; each is taken with the probability
/// `share`.
Training_rows rows_of_learned_run(const Training_graph& start, const Model& learned, double share,
                                  unsigned seed);

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_MERGING_RUNS_H
