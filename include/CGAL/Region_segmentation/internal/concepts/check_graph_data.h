// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_CHECK_GRAPH_DATA_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_CHECK_GRAPH_DATA_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/satisfies.h>

#include <cstddef>
#include <type_traits>
#include <utility>

// RegionData, SectionData

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename T>
using Adds_face = decltype(std::declval<T&>().add_face(std::declval<const Surface&>(),
                                                       std::size_t()));
template <typename T>
using Adds_border = decltype(std::declval<T&>().add_border(std::declval<const Surface&>(),
                                                           std::size_t()));
template <typename T, typename Section>
using Absorbs_region = decltype(std::declval<T&>().absorb(std::declval<const T&>(),
                                                          std::declval<const Section&>()));
template <typename T>
using Adds_adjacency = decltype(std::declval<T&>().add_adjacency(std::declval<const Surface&>(),
                                                                 std::size_t()));
template <typename T>
using Absorbs_section = decltype(std::declval<T&>().absorb(std::declval<const T&>()));

template <typename Region, typename Section>
constexpr bool check_graph_data()
{
  static_assert(std::is_default_constructible<Region>::value &&
                  std::is_copy_constructible<Region>::value,
                "a RegionData needs to be default and copy constructible");
  static_assert(satisfies<Adds_face, Region>,
                "a RegionData needs: void add_face(const Surface&, std::size_t face)");
  static_assert(satisfies<Adds_border, Region>,
                "a RegionData needs: void add_border(const Surface&, std::size_t adjacency)");
  static_assert(
    satisfies<Absorbs_region, Region, Section>,
    "a RegionData needs: void absorb(const RegionData& other, const SectionData& between)");
  static_assert(std::is_default_constructible<Section>::value &&
                  std::is_copy_constructible<Section>::value,
                "a SectionData needs to be default and copy constructible");
  static_assert(satisfies<Adds_adjacency, Section>,
                "a SectionData needs: void add_adjacency(const Surface&, std::size_t adjacency)");
  static_assert(satisfies<Absorbs_section, Section>,
                "a SectionData needs: void absorb(const SectionData& other)");
  return true;
}

/// The types `RegionData` and `SectionData` that a cost or a policy names; nothing if it names
/// none.
template <typename T, typename = void>
struct Data_named_by
{};
template <typename T>
struct Data_named_by<T, std::void_t<typename T::RegionData, typename T::SectionData>>
{
  using RegionData = typename T::RegionData;
  using SectionData = typename T::SectionData;
};

template <typename T>
using Names_data = std::void_t<typename T::RegionData, typename T::SectionData>;

/// Whether a cost or policy that names the data it reads can read those of a graph.
template <typename T, typename Graph>
constexpr bool reads_data_of()
{
  if constexpr (satisfies<Names_data, T>)
    return std::is_base_of<typename T::RegionData, typename Graph::RegionData>::value &&
           std::is_base_of<typename T::SectionData, typename Graph::SectionData>::value;
  else
    return true;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_CHECK_GRAPH_DATA_H
