// SPDX-License-Identifier: GPL-3.0-or-later

#include "merging_runs.h"

#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>

#include <cmath>
#include <random>

namespace train_merge_cost {

namespace RS = CGAL::Region_segmentation;

namespace {

using Section = Graph::section_descriptor;

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

/// Merges to the end.
template <typename Cost>
void merge_all(Graph& graph, Label_counts& counts, const Cost& cost)
{
  RS::Lowest_cost_first<Cost> policy(cost);
  policy.initialize(graph);
  while (const auto candidate = policy.next(graph)) {
    const Graph::Merge merge = graph.merge(candidate->section);
    counts.merge(merge.kept, merge.removed);
    policy.on_merge(graph, merge);
  }
}

/// Takes a random share of candidates as rows.
class Recorder
{
public:
  Recorder(const Label_counts& counts, double share, unsigned seed)
    : m_counts(counts)
    , m_share(share)
    , m_random(seed)
  {}

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
    if (recorder->takes_next())
      recorder->add(graph, s, Merge_features::of(graph, s));
    return cost(graph, s);
  }
};

} // namespace

Training_rows rows_of_visibility_run(const Training_graph& start, double noise, double share,
                                     unsigned seed)
{
  Graph graph = start.graph;
  Label_counts counts = start.counts;
  Recorder recorder(counts, share, seed);
  merge_all(graph, counts, Recorded_visibility_cost{&recorder, noise});
  return recorder.rows;
}

Training_rows rows_of_learned_run(const Training_graph& start, const Model& learned, double share,
                                  unsigned seed)
{
  Graph graph = start.graph;
  Label_counts counts = start.counts;
  Recorder recorder(counts, share, seed);
  merge_all(graph, counts, Recorded_learned_cost{&recorder, RS::Learned_cost(learned)});
  return recorder.rows;
}

} // namespace train_merge_cost
