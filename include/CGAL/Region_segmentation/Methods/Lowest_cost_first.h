// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_LOWEST_COST_FIRST_H
#define CGAL_REGION_SEGMENTATION_METHODS_LOWEST_COST_FIRST_H

#include <CGAL/Region_segmentation/Graph/Merge_candidate.h>
#include <CGAL/Region_segmentation/internal/concepts/check_merging.h>
#include <CGAL/Region_segmentation/internal/support/named_data.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// Turns a cost of sections into a policy: merges across the cheapest section of the graph next; of
/// equal ones, the one between the lower regions. A model of `RegionMergingPolicy`.
///
/// The order does not depend on the wanted number of segments, so one tree gives them all. A merge
/// changes only the costs of the sections of the merged region: a cost may depend on a section and on
/// its two regions.
///
/// Complexity: O(d log S) per merge, d the number of sections of the merged region.
///
/// \tparam Cost a model of `SectionCost`; a section whose cost is not a number is never merged across
template <typename Cost>
class Lowest_cost_first : public internal::Data_named_by<Cost>
{
public:
  using MergeCost = Cost; ///< the cost that defines the units of merges

  explicit Lowest_cost_first(Cost cost = Cost()) : m_cost(std::move(cost)) {}

  template <typename Graph>
  void initialize(const Graph& graph)
  {
    static_assert(internal::check_section_cost<Cost, Graph>());
    m_queue = Queue();
    m_versions.assign(graph.index_bound_of_sections(), 0);
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      push(graph, *range.first);
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    for (; !m_queue.empty(); m_queue.pop()) {
      const Entry& top = m_queue.top();
      if (is_current(graph, top))
        return Merge_candidate{top.section, top.cost};
    }
    return std::nullopt;
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    for (Section_descriptor s : graph.sections(merge.kept)) {
      ++m_versions[s.id()];
      push(graph, s);
    }
    if (m_queue.size() > 4 * graph.number_of_sections() + smallest_number_to_clean)
      remove_stale_entries(graph);
  }

private:
  struct Entry // stale once its section has a newer version
  {
    double cost;
    std::uint32_t lower, higher, version;
    Section_descriptor section;

    friend bool operator>(const Entry& a, const Entry& b)
    {
      return std::tie(a.cost, a.lower, a.higher) > std::tie(b.cost, b.lower, b.higher);
    }
  };
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;
  static constexpr std::size_t smallest_number_to_clean = 1024;

  /// Entries of a region with very many sections become stale with each of its merges: this bounds the memory. It
  /// takes the time of popping them.
  template <typename Graph>
  void remove_stale_entries(const Graph& graph)
  {
    std::vector<Entry> entries;
    for (; !m_queue.empty(); m_queue.pop())
      if (is_current(graph, m_queue.top()))
        entries.push_back(m_queue.top());
    m_queue = Queue(std::greater<Entry>(), std::move(entries));
  }

  template <typename Graph>
  bool is_current(const Graph& graph, const Entry& entry) const
  {
    return !graph.is_removed(entry.section) && m_versions[entry.section.id()] == entry.version;
  }

  template <typename Graph>
  void push(const Graph& graph, Section_descriptor s)
  {
    if (!graph.is_mergeable(s))
      return;
    const double cost = m_cost(graph, s);
    if (cost != cost)
      return;
    const std::uint32_t a = graph.source(s), b = graph.target(s);
    m_queue.push({cost, (std::min)(a, b), (std::max)(a, b), m_versions[s.id()], s});
  }

  Cost m_cost;
  Queue m_queue;
  std::vector<std::uint32_t> m_versions;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_LOWEST_COST_FIRST_H
