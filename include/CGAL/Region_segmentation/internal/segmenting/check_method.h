// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_CHECK_METHOD_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_CHECK_METHOD_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Methods/Segmentation_method.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/segmenting/check_annotator.h>
#include <CGAL/Region_segmentation/internal/concepts/check_merging.h>
#include <CGAL/Region_segmentation/internal/support/satisfies.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// RegionInitializer, NumberChooser, GraphPartitioner, SegmentationMethod

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename T>
constexpr bool is_initializer =
  std::is_invocable_r<Partition, const T&, const Flat_mesh&>::value;
template <typename T, typename ConcurrencyTag>
constexpr bool is_initializer_with_execution =
  std::is_invocable_r<Partition, const T&, const Flat_mesh&, const Execution<ConcurrencyTag>&>::value;

template <typename T>
constexpr bool check_region_initializer()
{
  static_assert(is_initializer<T> || is_initializer_with_execution<T, CGAL::Sequential_tag>,
                "a RegionInitializer needs: Partition operator()(const Flat_mesh&) const");
  return true;
}

/// Calls an initializer, with the execution if it accepts one.
template <typename Initializer, typename ConcurrencyTag>
Partition initialize_regions(const Initializer& initializer, const Flat_mesh& flat,
                             const Execution<ConcurrencyTag>& execution)
{
  Partition regions;
  if constexpr (is_initializer_with_execution<Initializer, ConcurrencyTag>)
    regions = initializer(flat, execution);
  else
    regions = initializer(flat);
  if (regions.size() != flat.number_of_faces())
    throw Invalid_method("the RegionInitializer made a partition of " + std::to_string(regions.size()) +
                         " elements for " + std::to_string(flat.number_of_faces()) + " faces");
  return regions;
}

template <typename T, typename ConcurrencyTag>
using Splits_regions = std::enable_if_t<std::is_convertible<
  decltype(std::declval<const T&>().split(std::declval<const Flat_mesh&>(), std::declval<const Partition&>(),
                                          std::size_t(), std::declval<const Execution<ConcurrencyTag>&>())),
  Partition>::value>;

/// `is_fixed(region)`
using Is_fixed = bool (*)(Partition::Index);

template <typename T, typename ConcurrencyTag>
using Straightens_borders = std::enable_if_t<std::is_convertible<
  decltype(std::declval<const T&>().straighten_borders(
    std::declval<const Flat_mesh&>(), std::declval<const Partition&>(), std::declval<const Merge_tree&>(),
    std::declval<Is_fixed>(), std::declval<const Execution<ConcurrencyTag>&>(), std::size_t())),
  std::vector<Partition::Index>>::value>;

/// A NumberChooser that is also asked with the mesh.
template <typename T>
using Sees_mesh = std::enable_if_t<std::is_convertible<
  decltype(std::declval<const T&>()(std::declval<const Merge_tree&>(), std::declval<const Flat_mesh&>())),
  std::size_t>::value>;

template <typename T>
constexpr bool check_number_chooser()
{
  static_assert(std::is_invocable_r<std::size_t, const T&, const Merge_tree&>::value,
                "a NumberChooser needs: std::size_t operator()(const Merge_tree&) const");
  return true;
}

template <typename T, typename Graph>
constexpr bool check_graph_partitioner()
{
  static_assert(reads_data_of<T, Graph>(),
                "the GraphPartitioner reads RegionData or SectionData that the annotator of the graph does not "
                "provide");
  static_assert(std::is_invocable_r<Partition, const T&, const Graph&, std::size_t>::value,
                "a GraphPartitioner needs: Partition operator()(const Graph&, std::size_t number_of_segments) const");
  return true;
}

template <typename T>
using Has_initializer_and_annotator =
  std::void_t<decltype(std::declval<const T&>().initializer), decltype(std::declval<const T&>().annotator)>;
template <typename T>
using Has_policy_and_chooser =
  std::void_t<decltype(std::declval<const T&>().policy), decltype(std::declval<const T&>().chooser)>;
template <typename T>
using Has_partitioner = decltype(std::declval<const T&>().partitioner);
template <typename T>
using Names_merge_cost = typename T::MergeCost;

/// Whether a chooser accepts the costs of a policy: those of the cost that it names, or any if it names none.
template <typename Chooser, typename Policy>
constexpr bool knows_costs_of()
{
  if constexpr (!satisfies<Names_merge_cost, Chooser>)
    return true;
  else if constexpr (satisfies<Names_merge_cost, Policy>)
    return std::is_same<typename Chooser::MergeCost, typename Policy::MergeCost>::value;
  else
    return false;
}

/// The types that belong to a method.
template <typename Method>
struct Method_traits
{
  static_assert(satisfies<Has_initializer_and_annotator, Method> &&
                  (satisfies<Has_policy_and_chooser, Method> || satisfies<Has_partitioner, Method>),
                "a SegmentationMethod needs the members initializer, annotator, and either policy and chooser or "
                "partitioner");
  using Initializer = std::decay_t<decltype(std::declval<const Method&>().initializer)>;
  using Annotator = std::decay_t<decltype(std::declval<const Method&>().annotator)>;
  using Graph = Graph_of<Annotator>;
  static constexpr bool is_partitioning = satisfies<Has_partitioner, Method>;
};

template <typename Method>
using Policy_of = std::decay_t<decltype(std::declval<const Method&>().policy)>;
template <typename Method>
using Chooser_of = std::decay_t<decltype(std::declval<const Method&>().chooser)>;

/// Whether one merge tree gives every number of segments.
template <typename Method>
constexpr bool has_one_tree()
{
  if constexpr (Method_traits<Method>::is_partitioning)
    return false;
  else
    return !depends_on_number<Policy_of<Method>, typename Method_traits<Method>::Graph>;
}

template <typename Method>
constexpr bool has_chooser()
{
  if constexpr (Method_traits<Method>::is_partitioning)
    return false;
  else
    return !std::is_same<Chooser_of<Method>, No_number_chooser>::value;
}

template <typename Method>
constexpr bool check_policy_and_chooser()
{
  static_assert(check_merging_policy<Policy_of<Method>, typename Method_traits<Method>::Graph>());
  if constexpr (has_chooser<Method>()) {
    static_assert(check_number_chooser<Chooser_of<Method>>());
    static_assert(has_one_tree<Method>(),
                  "a method whose order of merges depends on the number of segments has no NumberChooser: use "
                  "No_number_chooser");
    static_assert(knows_costs_of<Chooser_of<Method>, Policy_of<Method>>(),
                  "the NumberChooser is in the units of another cost than that of the RegionMergingPolicy: their "
                  "types MergeCost differ, or the policy names none");
  }
  return true;
}

template <typename Method>
constexpr bool check_method()
{
  using Traits = Method_traits<Method>;
  static_assert(check_region_initializer<typename Traits::Initializer>());
  static_assert(check_graph_annotator<typename Traits::Annotator>());
  if constexpr (Traits::is_partitioning)
    static_assert(check_graph_partitioner<std::decay_t<decltype(std::declval<const Method&>().partitioner)>,
                                          typename Traits::Graph>());
  else
    static_assert(check_policy_and_chooser<Method>());
  return true;
}

template <typename T>
using States_mesh_data = decltype(T::required_mesh_data);

/// The mesh data that a part of a method requires.
template <typename T>
constexpr Mesh_data mesh_data_of()
{
  if constexpr (satisfies<States_mesh_data, T>) {
    static_assert(std::is_same<std::decay_t<decltype(T::required_mesh_data)>, Mesh_data>::value,
                  "required_mesh_data is a static constexpr Mesh_data");
    return T::required_mesh_data;
  } else
    return Mesh_data::NOTHING_MORE;
}

/// The mesh data that a method requires.
template <typename Method>
constexpr Mesh_data required_mesh_data()
{
  using Traits = Method_traits<Method>;
  return mesh_data_of<typename Traits::Initializer>() | mesh_data_of<typename Traits::Annotator>() |
         mesh_data_of<typename Traits::Graph::RegionData>() | mesh_data_of<typename Traits::Graph::SectionData>();
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_CHECK_METHOD_H
