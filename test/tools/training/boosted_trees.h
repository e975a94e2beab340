// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_BOOSTED_TREES_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_BOOSTED_TREES_H

#include "Training_rows.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace train_merge_cost {

/// Trees are grown by XGBoost: leaf by leaf, the best split first, on histograms of the features.
struct Boosting_options
{
  unsigned number_of_trees = 120;
  unsigned number_of_leaves = 16; ///< at most `Model::Trees::maximum_number_of_leaves`
  double rate = 0.08;
  double share_of_rows = 0.5, share_of_features = 0.4; ///< a tree
  unsigned number_of_bins = 64;                        ///< a feature
  double lambda = 1;                                   ///< L2 penalty of the values of leaves
  double least_weight = 1;                             ///< of a leaf
};

/// A node of one of several trees.
struct Tree_node
{
  std::size_t feature;
  Model::Trees::Condition condition;
};

/// Trained trees with integer constants.
struct Integer_trees
{
  std::vector<Model::Trees::Condition> conditions;
  std::array<std::uint32_t, Merge_features::NUMBER_OF_FEATURES + 1> first_conditions{};
  std::vector<Model::Trees::Leaves> leaves;

  Integer_trees() = default;
  /// Sorts the nodes.
  Integer_trees(std::vector<Tree_node> nodes, std::vector<Model::Trees::Leaves> leaves_of_trees);

  /// Sorted by feature, threshold and tree.
  std::vector<Tree_node> nodes() const;

  /// Refers to this object.
  Model::Trees trees() const
  {
    return {conditions.data(), first_conditions, leaves.data(), leaves.size()};
  }
};

/// The sum of the trees is the logarithm of the odds. One thread; equal seeds give equal trees.
/// \throws std::runtime_error with the message of XGBoost
Integer_trees grow_trees(const Training_rows& rows, const Boosting_options& options, unsigned seed);

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_BOOSTED_TREES_H
