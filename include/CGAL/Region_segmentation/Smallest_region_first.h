// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SMALLEST_REGION_FIRST_H
#define CGAL_REGION_SEGMENTATION_SMALLEST_REGION_FIRST_H

#include <CGAL/Region_segmentation/Longest_flattest_section.h>
#include <CGAL/Region_segmentation/Merge_candidate.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// Step one of the paper: the region of smallest area goes next (the lower id of equal ones), across
/// the section that `Longest_flattest_section` chooses. A model of `RegionMergingPolicy`; the cost is
/// the area of the region, in squared units of the mesh.
///
/// Complexity: O(log R) a merge, and the choice of the section. A section is looked at O(log A) times,
/// A the ratio of the largest to the smallest area, since a region that is smallest twice has at least
/// doubled.
///
/// Source: Yang et al. 2014, section 3.3.
class Smallest_region_first
{
public:
  explicit Smallest_region_first(double beta = 0.1) : m_section_of(beta) {}

  template <typename Graph>
  void initialize(const Graph& graph, std::size_t /* number_of_segments */)
  {
    std::vector<Entry> entries;
    entries.reserve(graph.number_of_regions());
    for (auto range = vertices(graph); range.first != range.second; ++range.first)
      entries.push_back({graph[*range.first].area, *range.first});
    m_queue = Queue(std::greater<Entry>(), std::move(entries));
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    for (; !m_queue.empty(); m_queue.pop()) {
      const auto [area, region] = m_queue.top();
      if (graph.is_removed(region) || graph[region].area != area)
        continue;
      // A region without a section never gets one, so its entry can go.
      if (const auto section = m_section_of(graph, region))
        return Merge_candidate{*section, area};
    }
    return std::nullopt;
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    m_queue.push({graph[merge.kept].area, merge.kept});
  }

private:
  using Entry = std::pair<double, std::uint32_t>; // area, region: stale once the area has changed
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  Longest_flattest_section m_section_of;
  Queue m_queue;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SMALLEST_REGION_FIRST_H
