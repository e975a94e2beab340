// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TWO_STEP_SMALLEST_REGION_FIRST_H
#define CGAL_REGION_SEGMENTATION_TWO_STEP_SMALLEST_REGION_FIRST_H

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Two_step/longest_flattest_section.h>

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
/// Step one of the paper: merges the region of smallest area next, the lower id of equal ones,
/// across the section that `longest_flattest_section()` chooses. A region whose area is not a
/// number is never chosen. A model of `MergingPolicy`; the cost is the area of the region, in
/// squared units of `Surface::unit()`.
///
/// Complexity: O(log R) per merge, and the choice of the section.
class Smallest_region_first
{
public:
  /// `beta`: see `longest_flattest_section()`
  /// \throws Invalid_method if a constant is not in its range
  explicit Smallest_region_first(double beta = 0.1)
    : m_beta(beta)
  {
    internal::check_constant("Smallest_region_first: beta", beta, 0, 1);
  }

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
    // A region that cannot be merged leaves the queue: later merges do not change that.
    for (; !m_queue.empty(); m_queue.pop()) {
      const auto [area, region] = m_queue.top();
      if (!graph.is_removed(region) && graph[region].area == area)
        if (const auto section = longest_flattest_section(graph, region, m_beta))
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
  using Entry = std::pair<double, std::uint32_t>; // area, region; outdated if the region has
                                                  // another area
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  template <typename Graph>
  void push(const Graph& graph, std::uint32_t region)
  {
    if (!std::isnan(graph[region].area))
      m_queue.push({graph[region].area, region});
  }

  double m_beta;
  Queue m_queue;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TWO_STEP_SMALLEST_REGION_FIRST_H
