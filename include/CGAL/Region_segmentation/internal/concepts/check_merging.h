// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_CHECK_MERGING_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_CHECK_MERGING_H

#include <CGAL/Region_segmentation/internal/concepts/check_graph_data.h>
#include <CGAL/Region_segmentation/internal/support/satisfies.h>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

// SectionCost, MergingPolicy

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename T, typename Graph>
constexpr bool check_section_cost()
{
  static_assert(reads_data_of<T, Graph>(), "the SectionCost reads RegionData or SectionData that "
                                           "the annotator of the graph does not provide");
  static_assert(
    std::is_invocable_r<double, const T&, const Graph&, typename Graph::section_descriptor>::value,
    "a SectionCost needs: double operator()(const Graph&, section_descriptor) const");
  return true;
}

template <typename T, typename Graph>
using Initializes = decltype(std::declval<T&>().initialize(std::declval<const Graph&>()));
template <typename T, typename Graph>
using Proposes = std::enable_if_t<
  std::is_same<decltype(std::declval<T&>().next(std::declval<const Graph&>())->section),
               typename Graph::section_descriptor>::value &&
  std::is_convertible<decltype(std::declval<T&>().next(std::declval<const Graph&>())->cost),
                      double>::value>;
template <typename T, typename Graph>
using Observes_merges = decltype(std::declval<T&>().on_merge(
  std::declval<const Graph&>(), std::declval<typename Graph::Merge>()));

template <typename T, typename Graph>
constexpr bool check_merging_policy()
{
  static_assert(
    reads_data_of<T, Graph>(),
    "the MergingPolicy reads RegionData or SectionData that the annotator of the graph does not "
    "provide");
  static_assert(std::is_copy_constructible<T>::value,
                "a MergingPolicy needs to be copy constructible");
  static_assert(satisfies<Initializes, T, Graph>,
                "a MergingPolicy needs: void initialize(const Graph&)");
  static_assert(satisfies<Proposes, T, Graph>,
                "a MergingPolicy needs: std::optional<Merge_candidate> next(const Graph&)");
  static_assert(satisfies<Observes_merges, T, Graph>,
                "a MergingPolicy needs: void on_merge(const Graph&, const typename Graph::Merge&)");
  return true;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_CHECK_MERGING_H
