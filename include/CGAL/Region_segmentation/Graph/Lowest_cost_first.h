// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_LOWEST_COST_FIRST_H
#define CGAL_REGION_SEGMENTATION_GRAPH_LOWEST_COST_FIRST_H

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename Cost>
using Names_data = std::void_t<typename Cost::RegionData, typename Cost::SectionData>;

/// Whether a graph has the data that a cost names, if it names any.
template <typename Cost, typename Graph>
constexpr bool reads_data_of()
{
  if constexpr (satisfies<Names_data, Cost>)
    return std::is_base_of<typename Cost::RegionData, typename Graph::RegionData>::value &&
           std::is_base_of<typename Cost::SectionData, typename Graph::SectionData>::value;
  return true;
}

template <typename Cost, typename Graph>
constexpr bool check_section_cost()
{
  static_assert(reads_data_of<Cost, Graph>(), "the SectionCost names RegionData or SectionData "
                                              "that are not those of the graph");
  static_assert(std::is_invocable_r<double, const Cost&, const Graph&,
                                    typename Graph::section_descriptor>::value,
                "a SectionCost needs: double operator()(const Graph&, section_descriptor) const");
  return true;
}

template <typename Cost, typename Graph>
using Records_another_cost = decltype(double(
  std::declval<const Cost&>().recorded_cost(std::declval<const Graph&>(), Section_descriptor())));

} // namespace internal

/// \ingroup PkgRegionSegmentationPolicies
/// Makes a policy of a cost of sections: it merges across the section of lowest cost next; of equal
/// costs, across the section between the lower regions. A model of `MergingPolicy`.
///
/// A cost may depend on a section and on its two regions. So a merge changes only the costs of the
/// sections of the merged region. They are computed anew after the merge. If the region has d
/// sections, and d is greater than `hub_degree`, they are computed anew only after d / `hub_degree`
/// merges (rounded down) of the region. So all merges of a region with many sections take linear
/// time, and the costs of these sections are a little out of date.
///
/// Complexity: O(min(d, `hub_degree`) log S) per merge, amortized, d the number of sections of the
/// merged region.
///
/// The cost of a merge in the tree is the cost of the section. If `Cost` has a member function
/// `recorded_cost(graph, section)`, it is the value of this function, as where costs that determine
/// the order have no meaningful sum.
///
/// A lambda is a cost, too: `Lowest_cost_first([](const auto& graph, auto s) { return
/// graph[s].length; })`.
///
/// \tparam Cost a model of `SectionCost`; a section whose cost is not a number is never merged
///         across
template <typename Cost>
class Lowest_cost_first
{
public:
  static constexpr std::size_t hub_degree = 1024;

  Lowest_cost_first() = default;
  explicit Lowest_cost_first(Cost cost)
    : m_cost(std::move(cost))
  {}

  const Cost& cost() const { return m_cost; }

  void check_constants() const { internal::check_constants(m_cost); }

  template <typename Graph>
  void initialize(const Graph& graph)
  {
    static_assert(internal::check_section_cost<Cost, Graph>());
    m_queue = Queue();
    m_keys.assign(graph.index_bound_of_sections(), Key(std::nan(""), 0, 0));
    m_lags.assign(graph.index_bound_of_regions(), 0);
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      update(graph, *range.first);
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    for (; !m_queue.empty(); m_queue.pop()) {
      const auto [key, section] = m_queue.top();
      // A section may have been barred by seeds since it was pushed.
      if (!graph.is_removed(section) && graph.is_mergeable(section) &&
          key == m_keys[section.id()]) {
        if constexpr (internal::satisfies<internal::Records_another_cost, Cost, Graph>)
          return Merge_candidate{section, m_cost.recorded_cost(graph, section)};
        else
          return Merge_candidate{section, std::get<0>(key)};
      }
    }
    return std::nullopt;
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    std::uint32_t& lag = m_lags[merge.kept];
    lag = (std::max)(lag, m_lags[merge.removed]) + 1;
    if (lag < graph.degree(merge.kept) / hub_degree)
      return;
    lag = 0;
    for (Section_descriptor s : graph.sections(merge.kept))
      update(graph, s);
    if (m_queue.size() > 4 * graph.number_of_sections() + 1024) { // most entries are outdated
      m_queue = Queue();
      for (auto range = edges(graph); range.first != range.second; ++range.first)
        push(*range.first);
    }
  }

private:
  using Key = std::tuple<double, std::uint32_t, std::uint32_t>; // the cost, and the two regions
  using Entry = std::pair<Key, Section_descriptor>; // outdated once its section has another key
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  template <typename Graph>
  void update(const Graph& graph, Section_descriptor s)
  {
    if (!graph.is_mergeable(s))
      return;
    const auto [lower, higher] = std::minmax({graph.source(s), graph.target(s)});
    const Key key(m_cost(graph, s), lower, higher);
    if (m_keys[s.id()] == key)
      return;
    m_keys[s.id()] = key;
    push(s);
  }

  void push(Section_descriptor s)
  {
    if (!std::isnan(std::get<0>(m_keys[s.id()])))
      m_queue.push({m_keys[s.id()], s});
  }

  Cost m_cost;
  Queue m_queue;
  std::vector<Key> m_keys;           // by section
  std::vector<std::uint32_t> m_lags; // by region: its merges since its costs were computed
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_LOWEST_COST_FIRST_H
