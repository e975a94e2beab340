// SPDX-License-Identifier: GPL-3.0-or-later

#include "Training_model.h"

#include <CGAL/Region_segmentation/Graph/merge_regions.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Surface/internal/smooth_noise.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <map>
#include <utility>

namespace train_merge_cost {

namespace RS = CGAL::Region_segmentation;

namespace {

/// The labels of people as consecutive numbers.
std::vector<std::vector<int>> numbered_labels(const princeton_benchmark::Model& model)
{
  std::vector<std::vector<int>> result;
  for (const princeton_benchmark::Person& person : model.people) {
    std::map<int, int> number;
    std::vector<int> labels;
    for (int label : person.labels)
      labels.push_back(number.emplace(label, int(number.size())).first->second);
    result.push_back(std::move(labels));
  }
  return result;
}

} // namespace

Training_model make_training_model(int number, const princeton_benchmark::Model& model,
                                   const Training_model::Method& method)
{
  Training_model result;
  result.number = number;
  result.people = numbered_labels(model);
  result.surface = RS::internal::without_noise(
    RS::make_surface_of_polygon_soup(model.soup.points, model.soup.triangles), RS::Execution());
  const Training_model::Method::Prepared prepared = method.prepare(result.surface);
  const RS::Patches& cells = prepared.patches.fine;
  const std::vector<RS::Partition> draws = method.superfacets.draws(
    result.surface, prepared.patches, method.number_of_draws);
  const RS::Partition regions = composed(
    cells.of_elements(),
    RS::internal::join_degenerate_regions(result.surface, cells, draws.front()));
  result.graph = method.annotated_graph(result.surface, prepared.rays, cells, regions,
                                        RS::Execution());
  result.counts = Label_counts(std::vector<std::size_t>(regions.begin(), regions.end()),
                               regions.number_of_parts(), result.people);
  const RS::Merge_tree first_merges = RS::merge_regions(
    result.graph, RS::Visibility_merging().policy, Training_model::Method::most_learned_regions);
  for (const RS::Merge_tree::Merge& merge : first_merges.merges())
    result.counts.merge(merge.kept, merge.removed);
  return result;
}

} // namespace train_merge_cost
