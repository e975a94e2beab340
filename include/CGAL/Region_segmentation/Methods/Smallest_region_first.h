// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SMALLEST_REGION_FIRST_H
#define CGAL_REGION_SEGMENTATION_METHODS_SMALLEST_REGION_FIRST_H

#include <CGAL/Region_segmentation/Methods/Longest_flattest_section.h>
#include <CGAL/Region_segmentation/Graph/Merge_candidate.h>
#include <CGAL/Region_segmentation/internal/graph/Batch_queue.h>

#include <boost/range/adaptor/map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
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
  explicit Smallest_region_first(double beta = 0.1)
    : m_section_of(beta)
  {}

  template <typename Graph>
  void initialize(const Graph& graph)
  {
    m_section_of.check_section_data<Graph>();
    std::vector<Entry> entries;
    entries.reserve(graph.number_of_regions());
    for (auto range = vertices(graph); range.first != range.second; ++range.first)
      if (!std::isnan(graph[*range.first].area))
        entries.push_back({graph[*range.first].area, *range.first});
    m_queue.assign(std::move(entries));
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    do {
      for (; m_queue.has_top(); m_queue.pop()) {
        const Entry entry = m_queue.top();
        if (is_stale(graph, entry))
          continue;
        // A region without a section never gets one, so its entry is dropped.
        if (const auto section = m_section_of(graph, entry.second))
          return Merge_candidate{*section, entry.first};
      }
    } while (m_queue.next_batch([&graph](std::vector<Entry>& batch) { prepare(graph, batch); }));
    return std::nullopt;
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    if (!std::isnan(graph[merge.kept].area))
      m_queue.push({graph[merge.kept].area, merge.kept});
  }

private:
  using Entry = internal::Batch_queue::Entry; // area, region: stale once the area has changed

  template <typename Graph>
  static bool is_stale(const Graph& graph, const Entry& entry)
  {
    return graph.is_removed(entry.second) || graph[entry.second].area != entry.first;
  }

  template <typename Graph>
  static void prepare(const Graph& graph, std::vector<Entry>& batch)
  {
    batch.erase(std::remove_if(batch.begin(), batch.end(),
                               [&graph](const Entry& entry) { return is_stale(graph, entry); }),
                batch.end());
    graph.prefetch_neighborhoods(boost::adaptors::values(batch));
  }

  Longest_flattest_section m_section_of;
  internal::Batch_queue m_queue;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SMALLEST_REGION_FIRST_H
