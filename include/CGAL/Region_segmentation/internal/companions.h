// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_COMPANIONS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_COMPANIONS_H

#include <CGAL/Region_segmentation/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/grow_regions.h>
#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/concept_checks.h>

#include <type_traits>

// What a merging policy is used with unless the user says otherwise: each is a nested type of the policy,
// or a default.

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls a maker of regions, with the concurrency tag if it takes one.
template <typename ConcurrencyTag, typename Initializer>
Region_labels make_regions(const Initializer& initializer, const Flat_mesh& flat, const Edge_marks& is_feature)
{
  check_region_initializer<Initializer>();
  if constexpr (std::is_invocable<const Initializer&, const Flat_mesh&, const Edge_marks&,
                                  ConcurrencyTag>::value)
    return initializer(flat, is_feature, ConcurrencyTag());
  else
    return initializer(flat, is_feature);
}

/// Calls an annotator, with the concurrency tag if it takes one.
template <typename ConcurrencyTag, typename Annotator, typename Graph>
void annotate(const Annotator& annotator, Graph& graph, const Flat_mesh& flat, const Region_labels& regions)
{
  if constexpr (std::is_invocable<const Annotator&, Graph&, const Flat_mesh&, const Region_labels&,
                                  ConcurrencyTag>::value)
    annotator(graph, flat, regions, ConcurrencyTag());
  else
    annotator(graph, flat, regions);
}

/// The annotator of a policy that needs none.
struct No_annotation
{
  template <typename Graph>
  void operator()(Graph&, const Flat_mesh&, const Region_labels&) const {}
};

template <typename T, typename = void>
struct Initializer_for
{
  using type = Region_growing;
};
template <typename T>
struct Initializer_for<T, std::void_t<typename T::RegionInitializer>>
{
  using type = typename T::RegionInitializer;
};

template <typename T, typename = void>
struct Annotator_for
{
  using type = No_annotation;
};
template <typename T>
struct Annotator_for<T, std::void_t<typename T::GraphAnnotator>>
{
  using type = typename T::GraphAnnotator;
};

template <typename T, typename = void>
struct Graph_for
{
  using type = Region_adjacency_graph<>;
};
template <typename T>
struct Graph_for<T, std::void_t<typename T::RegionData, typename T::SectionData>>
{
  using type = Region_adjacency_graph<typename T::RegionData, typename T::SectionData>;
};

/// Stands for the chooser of a policy whose order depends on the wanted number.
struct No_chooser
{};

template <typename T, typename = void>
struct Chooser_for
{
  using type = No_chooser;
};
template <typename T>
struct Chooser_for<T, std::void_t<typename T::NumberChooser>>
{
  using type = typename T::NumberChooser;
};

template <typename Policy>
struct Companions_of_policy
{
  using RegionInitializer = typename Initializer_for<Policy>::type;
  using GraphAnnotator = typename Annotator_for<Policy>::type;
  using NumberChooser = typename Chooser_for<Policy>::type;
  using Graph = typename Graph_for<Policy>::type;
};

template <typename T, typename = void>
struct Content_for
{
  static constexpr Flat_mesh::Content value = Flat_mesh::Content::ANGLES;
};
template <typename T>
struct Content_for<T, std::void_t<decltype(T::content)>>
{
  static constexpr Flat_mesh::Content value = T::content;
};

/// What of the mesh a maker of regions or an annotator wants to be read.
template <typename T>
constexpr Flat_mesh::Content content_for(const T&)
{
  return Content_for<T>::value;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_COMPANIONS_H
