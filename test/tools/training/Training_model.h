// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TRAINING_MODEL_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TRAINING_MODEL_H

#include "Label_counts.h"

#include "models.h"

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <cstddef>
#include <string>
#include <vector>

namespace train_merge_cost {

using Graph = CGAL::Region_segmentation::Region_adjacency_graph<
  CGAL::Region_segmentation::Learned_region_data, CGAL::Region_segmentation::Learned_section_data>;

/// What is learned from: the regions from which the learned cost merges, and what people say of
/// them.
struct Training_graph
{
  Graph graph;
  Label_counts counts;
  double weight = 1; ///< of what is learned from it
};

/// A model to learn from; the graph is that of the first draw.
struct Training_model : Training_graph
{
  using Method = CGAL::Region_segmentation::Learned_merging;

  int number = 0; ///< in the benchmark, or above all of them: of its seeds
  std::string category;
  std::string collection = "benchmark"; ///< or furniture, or sheets
  std::vector<std::vector<int>> people; ///< the labels of the faces by each person, from 0 on
  CGAL::Region_segmentation::Surface surface;
  std::vector<Training_graph> variants; ///< of the same model, to learn from: with other faces
};

/// `method`: that of the first draw
Training_model make_training_model(int number, const princeton_benchmark::Model& model,
                                   const Training_model::Method& method);

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_TRAINING_MODEL_H
