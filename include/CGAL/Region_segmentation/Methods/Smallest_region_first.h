// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SMALLEST_REGION_FIRST_H
#define CGAL_REGION_SEGMENTATION_METHODS_SMALLEST_REGION_FIRST_H

#include <CGAL/Region_segmentation/Methods/Longest_flattest_section.h>
#include <CGAL/Region_segmentation/Graph/Merge_candidate.h>
#include <CGAL/Region_segmentation/Graph/geometry_data.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// Step one of the paper: merges the region of smallest area next (the lower id of equal ones;
/// never one whose area is NaN), across the section that `Longest_flattest_section` chooses. A
/// model of `MergingPolicy`; the cost is the area of the region, in squared units of
/// `Surface::unit()`.
///
/// Complexity: O(log R) per merge, and the choice of the section. A section is visited O(log A)
/// times, A the ratio of the largest to the smallest area, since a region that is smallest twice
/// has at least doubled.
///
/// Source: \cgalCite{YZWLL14}, section 3.3.
class Smallest_region_first
{
public:
  using RegionData = Region_geometry;
  using SectionData = Section_geometry;

  explicit Smallest_region_first(double beta = 0.1)
    : m_section_of(beta)
  {}

  template <typename Graph>
  void initialize(const Graph& graph)
  {
    m_queue = Queue();
    for (auto range = vertices(graph); range.first != range.second; ++range.first)
      push(graph, *range.first);
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    for (; !m_queue.empty(); m_queue.pop()) {
      const auto [area, region] = m_queue.top();
      if (graph.is_removed(region) || graph[region].area != area)
        continue;
      // A region without a section never gets one, so its entry is dropped.
      if (const auto section = m_section_of(graph, region))
        return Merge_candidate{*section, area};
    }
    return std::nullopt;
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    push(graph, merge.kept);
  }

private:
  using Entry = std::pair<double, std::uint32_t>; // area, region: stale once the area has changed
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  template <typename Graph>
  void push(const Graph& graph, std::uint32_t region)
  {
    if (!std::isnan(graph[region].area))
      m_queue.push({graph[region].area, region});
  }

  Longest_flattest_section m_section_of;
  Queue m_queue;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SMALLEST_REGION_FIRST_H
