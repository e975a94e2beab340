// SPDX-License-Identifier: GPL-3.0-or-later

#include "Model_score.h"

#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace train_merge_cost {

namespace RS = CGAL::Region_segmentation;

namespace {

double mean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// The distances to each person, by the number of segments, from the least number of the tree on,
/// which has `few` at most.
class Distances
{
public:
  Distances(const Training_model& model, const RS::Hierarchy& segments)
    : m_counts(std::vector<std::size_t>(segments.regions().begin(), segments.regions().end()),
               segments.regions().number_of_parts(), model.people)
  {
    const auto& merges = segments.merge_tree().merges();
    m_least = segments.merge_tree().number_of_regions() - merges.size();
    m_by_number.resize(merges.size() + 1);
    for (std::size_t i = 0; i <= merges.size(); ++i) {
      const std::size_t place = merges.size() - i;
      if (place <= most)
        m_by_number[place] = m_counts.distances();
      if (i < merges.size())
        m_counts.merge(merges[i].kept, merges[i].removed);
    }
    m_by_number.resize(std::min(m_by_number.size(), most + 1));
  }

  /// With the nearest possible number.
  const std::vector<double>& operator()(std::size_t number) const
  {
    return m_by_number[std::min(number > m_least ? number - m_least : 0, m_by_number.size() - 1)];
  }

  double lowest_mean() const
  {
    double lowest = std::numeric_limits<double>::max();
    for (const auto& distances : m_by_number)
      lowest = std::min(lowest, mean(distances));
    return lowest;
  }

private:
  static constexpr std::size_t most = 100; // more than are given or chosen

  Label_counts m_counts;
  std::size_t m_least;
  std::vector<std::vector<double>> m_by_number;
};

/// The paper's protocol: the people of the number k alone.
void set_paper_scores(Model_score& score, const Training_model& model,
                      const std::vector<double>& distances)
{
  score.nearest = score.first = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = distances.size(); i-- > 0;)
    if (model.segments_of_people[i] == model.number_of_segments) {
      score.first = distances[i];
      score.nearest = std::isnan(score.nearest) ? distances[i]
                                                : std::min(score.nearest, distances[i]);
    }
}

} // namespace

Model_score score_learned(const Training_model& model, const Model& learned)
{
  const RS::Learned_merging method(learned);
  const RS::Hierarchy segments = method.merge(model.surface, method.prepare(model.surface),
                                              RS::Request());
  const Distances distances(model, segments);
  Model_score result;
  result.given = mean(distances(model.number_of_segments));
  set_paper_scores(result, model, distances(model.number_of_segments));
  result.best = distances.lowest_mean();
  result.chosen_number = segments.number_of_segments();
  result.automatic = mean(distances(result.chosen_number));
  return result;
}

} // namespace train_merge_cost
