// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TRAINING_ROWS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TRAINING_ROWS_H

#include <CGAL/Region_segmentation/Superfacets/Merge_features.h>

#include <cstddef>
#include <vector>

namespace train_merge_cost {

using CGAL::Region_segmentation::Merge_features;
using Model = CGAL::Region_segmentation::Merge_model;

/// Possible merges, and what people say of them.
struct Training_rows
{
  std::vector<Merge_features::Values> features;
  std::vector<float> probabilities; ///< in [0, 1]
  std::vector<float> weights;

  std::size_t size() const { return features.size(); }

  void add(const Merge_features::Values& x, double probability, double weight)
  {
    features.push_back(x);
    probabilities.push_back(float(probability));
    weights.push_back(float(weight));
  }

  void append(const Training_rows& other)
  {
    features.insert(features.end(), other.features.begin(), other.features.end());
    probabilities.insert(probabilities.end(), other.probabilities.begin(),
                         other.probabilities.end());
    weights.insert(weights.end(), other.weights.begin(), other.weights.end());
  }
};

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TRAINING_ROWS_H
