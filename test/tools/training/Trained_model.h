// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TRAINED_MODEL_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TRAINED_MODEL_H

#include "Network.h"
#include "Training_rows.h"
#include "boosted_trees.h"

#include <vector>

namespace train_merge_cost {

/// The constants of a `Model`.
struct Trained_model
{
  Integer_trees trees;
  Integer_network network;

  /// Refers to this object.
  Model model() const { return {trees.trees(), network.network()}; }
};

struct Training_options
{
  Boosting_options trees;
  Network_options network;
};

/// The mean of the logarithms of the odds of several models, as one model.
Trained_model mean_of(const std::vector<Trained_model>& models);

inline Trained_model train(const Training_rows& rows, const Training_options& options,
                           unsigned seed)
{
  return {grow_trees(rows, options.trees, seed), train_networks(rows, options.network, seed)};
}

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TRAINED_MODEL_H
