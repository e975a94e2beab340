// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_CHECK_ANNOTATOR_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_CHECK_ANNOTATOR_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Methods/Geometry_annotator.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/concepts/check_graph_data.h>
#include <CGAL/Region_segmentation/internal/concepts/check_inherited_data.h>
#include <CGAL/Region_segmentation/internal/support/satisfies.h>

#include <type_traits>

// GraphAnnotator

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The graph that an annotator fills; that of `Geometry_annotator` for other types, so that the check below reports
/// them first.
template <typename Annotator, typename = void>
struct Graph_of_annotator
{
  using type = Region_adjacency_graph<>;
};
template <typename Annotator>
struct Graph_of_annotator<Annotator, Names_data<Annotator>>
{
  using type = Region_adjacency_graph<typename Annotator::RegionData, typename Annotator::SectionData>;
};
template <typename Annotator>
using Graph_of = typename Graph_of_annotator<Annotator>::type;

template <typename Annotator, typename Graph>
constexpr bool is_annotator =
  std::is_invocable<const Annotator&, Graph&, const Flat_mesh&, const Partition&>::value;
template <typename Annotator, typename Graph, typename ConcurrencyTag>
constexpr bool is_annotator_with_execution =
  std::is_invocable<const Annotator&, Graph&, const Flat_mesh&, const Partition&,
                    const Execution<ConcurrencyTag>&>::value;

template <typename T>
using Names_annotator = typename T::GraphAnnotator;

/// Whether data that require an annotator are filled by it, or by one derived from it.
template <typename Annotator, typename Data>
constexpr bool fills()
{
  if constexpr (satisfies<Names_annotator, Data>)
    return std::is_base_of<typename Data::GraphAnnotator, Annotator>::value;
  else
    return true;
}

template <typename T>
struct Is_geometry_annotator : std::false_type
{};
template <typename RegionData, typename SectionData>
struct Is_geometry_annotator<Geometry_annotator<RegionData, SectionData>> : std::true_type
{};

template <typename T>
constexpr bool check_graph_annotator()
{
  static_assert(satisfies<Names_data, T>,
                "a GraphAnnotator needs the nested types RegionData and SectionData: the data of the graph that it "
                "fills");
  if constexpr (satisfies<Names_data, T>) {
    static_assert(check_graph_data<typename T::RegionData, typename T::SectionData>());
    if constexpr (Is_geometry_annotator<T>::value)
      static_assert(check_inherited_sums<typename T::RegionData, typename T::SectionData>());
    static_assert(fills<T, typename T::RegionData>() && fills<T, typename T::SectionData>(),
                  "the GraphAnnotator does not fill its RegionData or SectionData: these name the one that does as "
                  "their GraphAnnotator");
    static_assert(is_annotator<T, Graph_of<T>> || is_annotator_with_execution<T, Graph_of<T>, CGAL::Sequential_tag>,
                  "a GraphAnnotator needs: void operator()(Graph&, const Flat_mesh&, const Partition& regions) const");
  }
  return true;
}

/// The data that an annotator keeps between calls for the same mesh; empty if it has no nested type `Cache`.
struct No_cache
{};
template <typename T, typename = void>
struct Cache_of
{
  using type = No_cache;
};
template <typename T>
struct Cache_of<T, std::void_t<typename T::Cache>>
{
  using type = typename T::Cache;
};

/// Calls an annotator, with the execution and the cache if it accepts them.
template <typename Annotator, typename Graph, typename ConcurrencyTag>
void annotate(const Annotator& annotator, Graph& graph, const Flat_mesh& flat, const Partition& regions,
              const Execution<ConcurrencyTag>& execution, typename Cache_of<Annotator>::type& cache)
{
  if constexpr (!std::is_same<typename Cache_of<Annotator>::type, No_cache>::value)
    annotator(graph, flat, regions, execution, cache);
  else if constexpr (is_annotator_with_execution<Annotator, Graph, ConcurrencyTag>)
    annotator(graph, flat, regions, execution);
  else
    annotator(graph, flat, regions);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_CHECK_ANNOTATOR_H
