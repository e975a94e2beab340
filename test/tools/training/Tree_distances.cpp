// SPDX-License-Identifier: GPL-3.0-or-later

#include "Tree_distances.h"

#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>

#include <algorithm>
#include <numeric>

namespace train_merge_cost {

namespace RS = CGAL::Region_segmentation;

Tree_distances::Tree_distances(const Training_model& model, const RS::Learned_merging& method)
{
  constexpr std::size_t most = 100; // more than are given or chosen
  const RS::Hierarchy segments = method.merge(model.surface, method.prepare(model.surface),
                                              RS::Request());
  m_chosen = segments.number_of_segments();
  const RS::Partition& regions = segments.regions();
  Label_counts counts({regions.begin(), regions.end()}, regions.number_of_parts(), model.people);
  const auto& merges = segments.merge_tree().merges();
  m_least = segments.merge_tree().number_of_regions() - merges.size();
  m_by_number.resize(std::min(merges.size(), most) + 1);
  for (std::size_t i = 0; i <= merges.size(); ++i) {
    if (merges.size() - i < m_by_number.size())
      m_by_number[merges.size() - i] = counts.distances();
    if (i < merges.size())
      counts.merge(merges[i].kept, merges[i].removed);
  }
}

std::size_t Tree_distances::best_number() const
{
  const auto sum = [](const std::vector<double>& distances) {
    return std::accumulate(distances.begin(), distances.end(), 0.0);
  };
  const auto best = std::min_element(m_by_number.begin(), m_by_number.end(),
                                     [&](const auto& a, const auto& b) { return sum(a) < sum(b); });
  return m_least + std::size_t(best - m_by_number.begin());
}

} // namespace train_merge_cost
