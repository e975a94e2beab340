// SPDX-License-Identifier: GPL-3.0-or-later

#include "merging_runs.h"

#include <CGAL/Region_segmentation/Methods/Learned_cost.h>
#include <CGAL/Region_segmentation/Methods/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Methods/Number_from_expected_costs.h>
#include <CGAL/Region_segmentation/Methods/Visibility_cost.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace train_merge_cost {

namespace RS = CGAL::Region_segmentation;

namespace {

using Section = Graph::section_descriptor;

/// The largest number that is chosen, as in `Learned_merging`.
constexpr std::size_t most_chosen = 60;

/// In (0, 1), from the bits of the generator.
double uniform(std::mt19937& random)
{
  return std::ldexp(double(random()) + 0.5, -32);
}

/// Box and Muller.
double normal(std::mt19937& random)
{
  const double radius = std::sqrt(-2 * std::log(uniform(random)));
  return radius * std::cos(6.283185307179586 * uniform(random));
}

/// Merges to the end. `on_merge(a, b, section, n)` is called before each merge of n regions.
template <typename Cost, typename OnMerge>
void merge_all(Graph& graph, Label_counts& counts, const Cost& cost, const OnMerge& on_merge)
{
  RS::Lowest_cost_first<Cost> policy(cost);
  policy.initialize(graph);
  while (const auto candidate = policy.next(graph)) {
    on_merge(candidate->section);
    const Graph::Merge merge = graph.merge(candidate->section);
    counts.merge(merge.kept, merge.removed);
    policy.on_merge(graph, merge);
  }
}

/// Takes a random share of candidates as rows.
class Recorder
{
public:
  Recorder(const Label_counts& counts, double share, unsigned seed) : m_counts(counts), m_share(share), m_random(seed) {}

  std::mt19937& random() { return m_random; }
  bool takes_next() { return uniform(m_random) < m_share; }

  void add(const Graph& graph, Section s, const Merge_features::Values& features)
  {
    const auto a = graph.source(s), b = graph.target(s);
    rows.add(features, m_counts.probability(a, b), std::sqrt(m_counts.share_of_pairs(a, b)) + 1e-6);
  }

  Training_rows rows;

private:
  const Label_counts& m_counts;
  double m_share;
  std::mt19937 m_random;
};

struct Recorded_visibility_cost
{
  Recorder* recorder;
  double noise;

  double operator()(const Graph& graph, Section s) const
  {
    if (recorder->takes_next())
      recorder->add(graph, s, Merge_features::of(graph, s));
    const double cost = RS::Visibility_cost()(graph, s);
    return noise > 0 ? cost + noise * normal(recorder->random()) : cost;
  }
};

struct Recorded_learned_cost
{
  Recorder* recorder;
  RS::Learned_cost cost;

  double operator()(const Graph& graph, Section s) const
  {
    const RS::Merge_estimate estimate(*cost.model, graph, s);
    if (recorder->takes_next())
      recorder->add(graph, s, estimate.features());
    return cost.of(estimate);
  }
};

double mean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// The paper's protocol: the people of the number k alone.
void set_paper_scores(Model_score& score, const Training_model& model, const std::vector<double>& distances)
{
  score.nearest = score.first = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = distances.size(); i-- > 0;)
    if (model.segments_of_people[i] == model.number_of_segments) {
      score.first = distances[i];
      score.nearest = std::isnan(score.nearest) ? distances[i] : std::min(score.nearest, distances[i]);
    }
}

/// `recorded`: the cost that the tree holds; `choose(tree)`: the number
template <typename Order, typename Recorded, typename Choose>
Model_score score(const Training_model& model, const Order& order, const Recorded& recorded, const Choose& choose)
{
  Graph graph = model.graph;
  Label_counts counts = model.counts;
  Model_score result;
  const std::size_t start = graph.number_of_regions();
  result.distances.assign(start + 1, 0);
  double distance = mean(counts.distances());
  RS::Merge_tree tree(graph.index_bound_of_regions());
  std::size_t fewest = start;
  result.distances[start] = distance;
  const auto reach = [&] {
    if (graph.number_of_regions() == std::max(model.number_of_segments, fewest))
      set_paper_scores(result, model, counts.distances());
  };
  merge_all(graph, counts, order, [&](Section s) {
    reach();
    const auto a = graph.source(s), b = graph.target(s);
    tree.push_back({std::min(a, b), std::max(a, b), recorded(graph, s)});
    distance += counts.share_of_pairs(a, b) * (1 - 2 * counts.probability(a, b));
    result.distances[--fewest] = distance;
  });
  reach();
  for (std::size_t n = 0; n < fewest; ++n)
    result.distances[n] = distance;
  const auto at = [&](std::size_t n) { return result.distances[std::min(n, start)]; };
  result.given = at(model.number_of_segments);
  result.best = *std::min_element(result.distances.begin() + std::ptrdiff_t(std::max<std::size_t>(1, fewest)),
                                  result.distances.end());
  // The tree starts at the regions that are left.
  const std::size_t before = graph.index_bound_of_regions() - start;
  result.chosen_number = choose(tree, before);
  result.automatic = at(result.chosen_number);
  return result;
}

} // namespace

Training_rows rows_of_visibility_run(const Training_model& model, double noise, double share, unsigned seed)
{
  Graph graph = model.graph;
  Label_counts counts = model.counts;
  Recorder recorder(counts, share, seed);
  merge_all(graph, counts, Recorded_visibility_cost{&recorder, noise}, [](Section) {});
  return recorder.rows;
}

Training_rows rows_of_learned_run(const Training_model& model, const Model& learned, double share, unsigned seed)
{
  Graph graph = model.graph;
  Label_counts counts = model.counts;
  Recorder recorder(counts, share, seed);
  merge_all(graph, counts, Recorded_learned_cost{&recorder, RS::Learned_cost(learned)}, [](Section) {});
  return recorder.rows;
}

Model_score score_learned(const Training_model& model, const Model& learned)
{
  return score(model, RS::Learned_cost(learned), RS::Expected_merge_cost(learned),
               [](const RS::Merge_tree& tree, std::size_t before) {
                 return RS::Number_from_expected_costs<RS::Expected_merge_cost>(most_chosen).number(tree.merges(),
                                                                     tree.number_of_regions() - before);
               });
}

Model_score score_visibility(const Training_model& model)
{
  Model_score result = score(model, RS::Visibility_cost(), RS::Visibility_cost(),
                             [](const RS::Merge_tree&, std::size_t) { return std::size_t(0); });
  result.automatic = std::numeric_limits<double>::quiet_NaN();
  return result;
}

} // namespace train_merge_cost
