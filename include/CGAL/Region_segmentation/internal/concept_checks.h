// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPT_CHECKS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPT_CHECKS_H

#include <CGAL/Region_segmentation/internal/Region_labels.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

// Each requirement of a concept is one alias; a static_assert for each says which one a type misses.

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename, template <typename...> class Requirement, typename... Types>
struct Satisfies : std::false_type
{};

template <template <typename...> class Requirement, typename... Types>
struct Satisfies<std::void_t<Requirement<Types...>>, Requirement, Types...> : std::true_type
{};

template <template <typename...> class Requirement, typename... Types>
constexpr bool satisfies = Satisfies<void, Requirement, Types...>::value;

// RegionInitializer

template <typename T>
using Makes_regions = std::enable_if_t<std::is_convertible<
  decltype(std::declval<const T&>()(std::declval<const Flat_mesh&>(),
                                    std::declval<const Edge_marks&>())),
  Region_labels>::value>;

template <typename T>
void check_region_initializer()
{
  static_assert(satisfies<Makes_regions, T>,
                "a RegionInitializer needs: Region_labels operator()(const Flat_mesh&, "
                "const Edge_marks&) const");
}

// RegionData, SectionData

template <typename T>
using Adds_face = decltype(std::declval<T&>().add_face(std::declval<const Flat_mesh&>(),
                                                       std::size_t()));
template <typename T>
using Adds_border_edge = decltype(std::declval<T&>().add_border_edge(
  std::declval<const Flat_mesh&>(), std::size_t(), std::size_t()));
template <typename T, typename Section>
using Absorbs_region = decltype(std::declval<T&>().absorb(std::declval<const T&>(),
                                                          std::declval<const Section&>()));
template <typename T>
using Adds_edge = decltype(std::declval<T&>().add_edge(std::declval<const Flat_mesh&>(),
                                                       std::size_t(), std::size_t()));
template <typename T>
using Absorbs_section = decltype(std::declval<T&>().absorb(std::declval<const T&>()));

template <typename Region, typename Section>
void check_graph_data()
{
  static_assert(std::is_default_constructible<Region>::value &&
                  std::is_copy_constructible<Region>::value,
                "a RegionData needs to be default and copy constructible");
  static_assert(satisfies<Adds_face, Region>,
                "a RegionData needs: void add_face(const Flat_mesh&, std::size_t face)");
  static_assert(satisfies<Adds_border_edge, Region>,
                "a RegionData needs: void add_border_edge(const Flat_mesh&, std::size_t lower_face, "
                "std::size_t edge)");
  static_assert(satisfies<Absorbs_region, Region, Section>,
                "a RegionData needs: void absorb(const RegionData& other, const SectionData& between)");
  static_assert(std::is_default_constructible<Section>::value &&
                  std::is_copy_constructible<Section>::value,
                "a SectionData needs to be default and copy constructible");
  static_assert(satisfies<Adds_edge, Section>,
                "a SectionData needs: void add_edge(const Flat_mesh&, std::size_t lower_face, "
                "std::size_t edge)");
  static_assert(satisfies<Absorbs_section, Section>,
                "a SectionData needs: void absorb(const SectionData& other)");
}

// SectionCost

template <typename T, typename Graph>
using Has_cost = std::enable_if_t<std::is_convertible<
  decltype(std::declval<const T&>()(std::declval<const Graph&>(),
                                    std::declval<typename Graph::section_descriptor>())),
  double>::value>;

template <typename T, typename Graph>
void check_section_cost()
{
  static_assert(satisfies<Has_cost, T, Graph>,
                "a SectionCost needs: double operator()(const Graph&, section_descriptor) const");
}

// RegionMergingPolicy

template <typename T, typename Graph>
using Initializes = decltype(std::declval<T&>().initialize(std::declval<const Graph&>(),
                                                           std::size_t()));
template <typename T, typename Graph>
using Proposes = std::enable_if_t<
  std::is_same<decltype(std::declval<T&>().next(std::declval<const Graph&>())->section),
               typename Graph::section_descriptor>::value &&
  std::is_convertible<decltype(std::declval<T&>().next(std::declval<const Graph&>())->cost),
                      double>::value>;
template <typename T, typename Graph>
using Hears = decltype(std::declval<T&>().on_merge(std::declval<const Graph&>(),
                                                   std::declval<typename Graph::Merge>()));

template <typename T, typename Graph>
void check_merging_policy()
{
  static_assert(satisfies<Initializes, T, Graph>,
                "a RegionMergingPolicy needs: void initialize(const Graph&, "
                "std::size_t number_of_segments)");
  static_assert(satisfies<Proposes, T, Graph>,
                "a RegionMergingPolicy needs: std::optional<Merge_candidate> next(const Graph&)");
  static_assert(satisfies<Hears, T, Graph>,
                "a RegionMergingPolicy needs: void on_merge(const Graph&, "
                "const typename Graph::Merge&)");
}

// StopPredicate

template <typename T, typename Graph>
using Stops = std::enable_if_t<std::is_convertible<
  decltype(std::declval<T&>()(std::declval<const Graph&>(), double())), bool>::value>;

template <typename T, typename Graph>
void check_stop_predicate()
{
  static_assert(satisfies<Stops, T, Graph>,
                "a MergingStopPredicate needs: bool operator()(const Graph&, double next_cost)");
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPT_CHECKS_H
