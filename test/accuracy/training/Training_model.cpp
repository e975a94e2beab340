// SPDX-License-Identifier: GPL-3.0-or-later

#include "Training_model.h"

#include "Benchmark_mesh.h"

#include <CGAL/Region_segmentation/Methods/Learned_annotator.h>
#include <CGAL/Region_segmentation/Methods/Superfacets.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/merge_regions.h>
#include <CGAL/Region_segmentation/read_flat_mesh.h>

#include <algorithm>
#include <map>

namespace train_merge_cost {

namespace RS = CGAL::Region_segmentation;

namespace {

/// The labels of people as consecutive numbers.
std::vector<std::vector<int>> numbered_labels(const princeton_benchmark::Model& model)
{
  std::vector<std::vector<int>> result;
  for (const princeton_benchmark::Truth& truth : model.truths) {
    std::map<int, int> number;
    std::vector<int> labels;
    for (int label : truth.labels)
      labels.push_back(number.emplace(label, int(number.size())).first->second);
    result.push_back(std::move(labels));
  }
  return result;
}

} // namespace

Training_model make_training_model(int number, const princeton_benchmark::Model& model, std::size_t superfacets,
                                   std::size_t few)
{
  Training_model result;
  result.number = number;
  result.number_of_segments = model.number_of_segments;
  for (const princeton_benchmark::Truth& truth : model.truths)
    result.segments_of_people.push_back(truth.number_of_segments);
  result.people = numbered_labels(model);
  result.mesh = RS::read_flat_mesh(princeton_benchmark::make_mesh(model.soup),
                                   RS::Mesh_data::POINTS | RS::Mesh_data::PATCHES);
  result.regions = RS::Superfacets(superfacets)(result.mesh);
  result.graph = RS::build_region_adjacency_graph(result.mesh, result.regions, RS::Learned_annotator());
  result.first_merges = RS::merge_regions(result.graph, RS::Visibility_merging().policy, 1, RS::Stop_at_count{few});
  result.counts = Label_counts(std::vector<std::size_t>(result.regions.begin(), result.regions.end()),
                               result.regions.number_of_parts(), result.people);
  for (const RS::Merge_tree::Merge& merge : result.first_merges.merges())
    result.counts.merge(merge.kept, merge.removed);
  return result;
}

} // namespace train_merge_cost
