// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_POLICY_SEQUENCE_H
#define CGAL_REGION_SEGMENTATION_POLICY_SEQUENCE_H

#include <CGAL/Region_segmentation/Merge_candidate.h>
#include <CGAL/Region_segmentation/internal/named_data.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// Changes policies when the number of regions is at most a multiple of the wanted number of segments.
struct Switch_at_multiple
{
  double factor; ///< at least 1

  bool operator()(std::size_t number_of_regions, std::size_t number_of_segments) const
  {
    return double(number_of_regions) <= factor * double(number_of_segments);
  }
};

/// \ingroup PkgRegionSegmentationPolicies
/// Changes policies at a number of regions, whatever the wanted number of segments.
struct Switch_at_count
{
  std::size_t count;

  bool operator()(std::size_t number_of_regions, std::size_t /* number_of_segments */) const
  {
    return number_of_regions <= count;
  }
};

/// \ingroup PkgRegionSegmentationPolicies
/// One policy, then another. A model of `RegionMergingPolicy`; it needs the data that the first one
/// names.
///
/// \tparam First, Second models of `RegionMergingPolicy`, a sequence among them
/// \tparam Switch `Switch_at_multiple`, `Switch_at_count`, or a function object like them: whether the
///         second policy takes over
template <typename First, typename Second, typename Switch>
class Policy_sequence : public internal::Data_named_by<First>
{
public:
  Policy_sequence(First first, Second second, Switch is_time)
    : m_first(std::move(first)), m_second(std::move(second)), m_is_time(is_time)
  {}

  template <typename Graph>
  void initialize(const Graph& graph, std::size_t number_of_segments)
  {
    m_number_of_segments = number_of_segments;
    m_is_second = false;
    m_first.initialize(graph, number_of_segments);
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    if (!m_is_second && m_is_time(graph.number_of_regions(), m_number_of_segments)) {
      m_is_second = true;
      m_second.initialize(graph, m_number_of_segments);
    }
    return m_is_second ? m_second.next(graph) : m_first.next(graph);
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    if (m_is_second)
      m_second.on_merge(graph, merge);
    else
      m_first.on_merge(graph, merge);
  }

private:
  First m_first;
  Second m_second;
  Switch m_is_time;
  std::size_t m_number_of_segments = 1;
  bool m_is_second = false;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_POLICY_SEQUENCE_H
