// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_POLICY_SEQUENCE_H
#define CGAL_REGION_SEGMENTATION_METHODS_POLICY_SEQUENCE_H

#include <CGAL/Region_segmentation/Graph/Merge_candidate.h>
#include <CGAL/Region_segmentation/internal/concepts/check_merging.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// Changes policies when the number of regions is at most a multiple of the wanted number of
/// segments.
struct Switch_at_multiple
{
  double factor; ///< at least 1

  bool operator()(std::size_t number_of_regions, std::size_t number_of_segments) const
  {
    return double(number_of_regions) <= factor * double(number_of_segments);
  }
};

/// \ingroup PkgRegionSegmentationPolicies
/// Changes policies at a fixed number of regions, independently of the wanted number of segments.
struct Switch_at_count
{
  std::size_t count;

  bool operator()(std::size_t number_of_regions, std::size_t) const
  {
    return number_of_regions <= count;
  }
};

/// \ingroup PkgRegionSegmentationPolicies
/// One policy, then another. A model of `MergingPolicy`.
///
/// Its order depends on the wanted number of segments if one of the policies or the switch does.
///
/// \tparam First, Second models of `MergingPolicy`, such as another sequence
/// \tparam Switch `Switch_at_multiple`, `Switch_at_count`, or a similar function object of the
///         number of regions and the wanted number of segments: whether the second policy takes
///         over
template <typename First, typename Second, typename Switch>
class Policy_sequence
{
public:
  First first;
  Second second;
  Switch is_time_for_second;

  Policy_sequence(First first_, Second second_, Switch is_time_for_second_)
    : first(std::move(first_))
    , second(std::move(second_))
    , is_time_for_second(is_time_for_second_)
  {}

  template <typename Graph>
  void initialize(const Graph& graph, std::size_t number_of_segments)
  {
    static_assert(internal::check_merging_policy<First, Graph>());
    static_assert(internal::check_merging_policy<Second, Graph>());
    m_number_of_segments = number_of_segments;
    m_is_second = false;
    first.initialize(graph, number_of_segments);
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    if (!m_is_second && is_time_for_second(graph.number_of_regions(), m_number_of_segments)) {
      m_is_second = true;
      second.initialize(graph, m_number_of_segments);
    }
    return m_is_second ? second.next(graph) : first.next(graph);
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    if (m_is_second)
      second.on_merge(graph, merge);
    else
      first.on_merge(graph, merge);
  }

private:
  std::size_t m_number_of_segments = 1;
  bool m_is_second = false;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_POLICY_SEQUENCE_H
