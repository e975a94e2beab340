// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_SECTION_QUEUE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_SECTION_QUEUE_H

#include <CGAL/Region_segmentation/Graph/Merge_candidate.h>
#include <CGAL/Region_segmentation/Graph/Section_descriptor.h>
#include <CGAL/Region_segmentation/internal/support/Function_ref.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The sections of a graph by their costs, for `Lowest_cost_first`: independent of the cost, so
/// that it is compiled once for a graph.
class Section_queue
{
public:
  /// Regions of more sections are hubs; a graph of at most as many regions has none.
  static constexpr std::size_t hub_degree = 1024;
  using Cost_of = Function_ref<double(Section_descriptor)>;

  template <typename Graph>
  void initialize(const Graph& graph, Cost_of cost)
  {
    m_queue.clear();
    m_entries.assign(graph.index_bound_of_sections(), Entry());
    m_lags.assign(graph.index_bound_of_regions(), 0);
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      update(graph, *range.first, cost);
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    while (!m_queue.empty() && !is_current(graph, m_queue.front())) {
      std::pop_heap(m_queue.begin(), m_queue.end(), std::greater<Entry>());
      m_queue.pop_back();
    }
    if (m_queue.empty())
      return std::nullopt;
    remember_neighbors(graph, m_queue.front());
    return Merge_candidate{m_queue.front().section, m_queue.front().cost};
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge, Cost_of cost)
  {
    std::uint32_t& lag = m_lags[merge.kept];
    lag = (std::max)(lag, m_lags[merge.removed]) + 1;
    if (lag < graph.degree(merge.kept) / hub_degree)
      for (const std::uint32_t neighbor : m_neighbors)
        update(graph, *graph.section(merge.kept, neighbor), cost);
    else {
      lag = 0;
      for (Section_descriptor s : graph.sections(merge.kept))
        update(graph, s, cost);
    }
    if (m_queue.size() > 4 * graph.number_of_sections() + smallest_number_to_clean)
      remove_stale_entries(graph);
  }

private:
  struct Entry // stale once its section has a newer version
  {
    double cost = std::numeric_limits<double>::quiet_NaN();
    std::uint32_t lower = 0, higher = 0, version = 0;
    Section_descriptor section;

    friend bool operator>(const Entry& a, const Entry& b)
    {
      return std::tie(a.cost, a.lower, a.higher) > std::tie(b.cost, b.lower, b.higher);
    }
  };
  static constexpr std::size_t smallest_number_to_clean = 1024;

  /// Entries of a region with very many sections become stale with its merges: this bounds the
  /// memory.
  template <typename Graph>
  void remove_stale_entries(const Graph& graph)
  {
    m_queue.erase(std::remove_if(m_queue.begin(), m_queue.end(),
                                 [&](const Entry& entry) { return !is_current(graph, entry); }),
                  m_queue.end());
    std::make_heap(m_queue.begin(), m_queue.end(), std::greater<Entry>());
  }

  /// Before a merge into a hub, those of the other region: the sections of the hub to them will be
  /// moved or united.
  template <typename Graph>
  void remember_neighbors(const Graph& graph, const Entry& candidate)
  {
    // Not those of the entry: the region of a hub may have got another number since.
    std::uint32_t fewer = graph.source(candidate.section), more = graph.target(candidate.section);
    if (graph.degree(fewer) > graph.degree(more))
      std::swap(fewer, more);
    m_neighbors.clear();
    if (graph.degree(more) <= hub_degree)
      return;
    for (Section_descriptor s : graph.sections(fewer))
      if (graph.target(s) != more)
        m_neighbors.push_back(graph.target(s));
  }

  template <typename Graph>
  bool is_current(const Graph& graph, const Entry& entry) const
  {
    return !graph.is_removed(entry.section) &&
           m_entries[entry.section.id()].version == entry.version &&
           graph.is_mergeable(entry.section); // seeds bar sections later
  }

  /// Entries that have not changed are not pushed again.
  template <typename Graph>
  void update(const Graph& graph, Section_descriptor s, Cost_of cost_of)
  {
    if (!graph.is_mergeable(s))
      return;
    const double cost = cost_of(s);
    const std::uint32_t a = graph.source(s), b = graph.target(s);
    Entry& entry = m_entries[s.id()];
    if (entry.cost == cost && entry.lower == (std::min)(a, b) && entry.higher == (std::max)(a, b))
      return;
    entry = {cost, (std::min)(a, b), (std::max)(a, b), entry.version + 1, s};
    if (cost != cost)
      return;
    m_queue.push_back(entry);
    std::push_heap(m_queue.begin(), m_queue.end(), std::greater<Entry>());
  }

  std::vector<Entry> m_queue;        // a heap, the next one first
  std::vector<Entry> m_entries;      // by section, the newest
  std::vector<std::uint32_t> m_lags; // by region: its merges since all of its sections were updated
  std::vector<std::uint32_t> m_neighbors; // of the smaller region of the next merge, if the other
                                          // one is a hub
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_SECTION_QUEUE_H
