// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TREE_DISTANCES_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TREE_DISTANCES_H

#include "Training_model.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace train_merge_cost {

/// The Rand index distances between what `segment()` gives by a method, for any number of segments,
/// and the segmentations by people.
class Tree_distances
{
public:
  Tree_distances(const Training_model& model,
                 const CGAL::Region_segmentation::Learned_merging& method);

  /// By person, with the nearest possible number of segments, which is 100 at most.
  const std::vector<double>& operator()(std::size_t number) const
  {
    return m_by_number[number > m_least ? std::min(number - m_least, m_by_number.size() - 1) : 0];
  }

  std::size_t chosen_number() const { return m_chosen; }
  /// The number with the least mean distance, in hindsight.
  std::size_t best_number() const;

private:
  std::size_t m_least, m_chosen;
  std::vector<std::vector<double>> m_by_number; // from the least number of the tree on
};

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TREE_DISTANCES_H
