// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_CHECK_PARTS_H
#define CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_CHECK_PARTS_H

// What is called of RegionData, SectionData, SectionCost, MergingPolicy, GraphAnnotator: a sentence
// for each.

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

struct Region_rays;
template <typename RegionData, typename SectionData>
class Region_adjacency_graph;

namespace internal {

template <typename T>
T& lvalue() noexcept; // as std::declval<T&>()

template <typename T, typename Section>
using Is_region_data = decltype(T(), T(lvalue<const T>()),
                                lvalue<T>().add_face(lvalue<const Surface>(), std::size_t()),
                                lvalue<T>().add_border(lvalue<const Surface>(), std::size_t()),
                                lvalue<T>().absorb(lvalue<const T>(), lvalue<const Section>()));
template <typename T>
using Is_section_data = decltype(T(), T(lvalue<const T>()),
                                 lvalue<T>().add_adjacency(lvalue<const Surface>(), std::size_t()),
                                 lvalue<T>().absorb(lvalue<const T>()));

template <typename Region, typename Section>
constexpr bool check_graph_data()
{
  static_assert(satisfies<Is_region_data, Region, Section>,
                "a RegionData is default and copy constructible, and needs: void add_face(const "
                "Surface&, std::size_t face), void add_border(const Surface&, std::size_t "
                "adjacency), void absorb(const RegionData& other, const SectionData& between)");
  static_assert(satisfies<Is_section_data, Section>,
                "a SectionData is default and copy constructible, and needs: void add_adjacency("
                "const Surface&, std::size_t adjacency), void absorb(const SectionData& other)");
  return true;
}

template <typename T>
using Names_data = std::void_t<typename T::RegionData, typename T::SectionData>;

/// Whether a graph has the data that a cost or policy names, if it names any.
template <typename T, typename Graph>
constexpr bool reads_data_of()
{
  if constexpr (satisfies<Names_data, T>)
    return std::is_base_of<typename T::RegionData, typename Graph::RegionData>::value &&
           std::is_base_of<typename T::SectionData, typename Graph::SectionData>::value;
  return true;
}

template <typename T, typename Graph>
constexpr bool check_section_cost()
{
  static_assert(reads_data_of<T, Graph>(), "the SectionCost names RegionData or SectionData that "
                                           "are not those of the graph");
  static_assert(
    std::is_invocable_r<double, const T&, const Graph&, typename Graph::section_descriptor>::value,
    "a SectionCost needs: double operator()(const Graph&, section_descriptor) const");
  return true;
}

template <typename T, typename Graph>
using Is_merging_policy = decltype(T(lvalue<const T>()),
                                   lvalue<T>().initialize(lvalue<const Graph>()),
                                   Merge_candidate(*lvalue<T>().next(lvalue<const Graph>())),
                                   lvalue<T>().on_merge(lvalue<const Graph>(),
                                                        lvalue<const typename Graph::Merge>()));

template <typename T, typename Graph>
constexpr bool check_merging_policy()
{
  static_assert(reads_data_of<T, Graph>(), "the MergingPolicy names RegionData or SectionData that "
                                           "are not those of the graph");
  static_assert(satisfies<Is_merging_policy, T, Graph>,
                "a MergingPolicy is copy constructible, and needs: void initialize(const Graph&), "
                "std::optional<Merge_candidate> next(const Graph&), void on_merge(const Graph&, "
                "const Graph::Merge&)");
  return true;
}

template <typename T>
using Is_annotator = decltype(lvalue<const T>()(
  lvalue<Region_adjacency_graph<typename T::RegionData, typename T::SectionData>>(),
  lvalue<const Surface>(), lvalue<const Partition>(), lvalue<const Region_rays>()));

template <typename T>
constexpr bool check_annotator()
{
  static_assert(satisfies<Is_annotator, T>,
                "a GraphAnnotator needs the nested types RegionData and SectionData, and: void "
                "operator()(Graph&, const Surface&, const Partition& regions, const Region_rays&) "
                "const");
  return true;
}

} // namespace internal

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_CHECK_PARTS_H
