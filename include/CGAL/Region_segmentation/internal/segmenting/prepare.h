// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_PREPARE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_PREPARE_H

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/face_values.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/segmenting/Prepared_mesh.h>
#include <CGAL/Region_segmentation/internal/support/options.h>
#include <CGAL/Region_segmentation/parameters.h>
#include <CGAL/Region_segmentation/read_flat_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

// Shared by segment() and Segmenter: from a mesh and a pack to a prepared mesh, and the outputs requested by a pack.

namespace CGAL {
namespace Region_segmentation {
namespace internal {

using Segmenting_parameters =
  Tag_list<internal_np::number_of_segments_t, internal_np::method_t, internal_np::face_seed_map_t,
           internal_np::region_map_t, internal_np::merge_tree_t, CGAL::internal_np::edge_is_constrained_t,
           CGAL::internal_np::visitor_t>;

/// The method of a pack, or the default one.
template <typename NamedParameters>
using Method_of_pack =
  std::decay_t<decltype(CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(pack(std::declval<const NamedParameters&>()), internal_np::method),
    Learned_merging()))>;

/// The method of a pack, or else a default-constructed one: a given method need not be default constructible.
template <typename Method, typename Pack>
Method method_of_pack(const Pack& np)
{
  if constexpr (CGAL::parameters::is_default_parameter<Pack, internal_np::method_t>::value)
    return Method();
  else {
    using Given = std::decay_t<decltype(CGAL::parameters::get_parameter(np, internal_np::method))>;
    static_assert(std::is_convertible<Given, Method>::value,
                  "the Segmenter is of another type than the method: omit its template arguments, which are deduced in "
                  "Segmenter segmenter(mesh, parameters::method(m))");
    return CGAL::parameters::get_parameter(np, internal_np::method);
  }
}

template <typename Pack>
constexpr bool has_seeds = !CGAL::parameters::is_default_parameter<Pack, internal_np::face_seed_map_t>::value;
template <typename Pack>
constexpr bool has_merge_tree = !CGAL::parameters::is_default_parameter<Pack, internal_np::merge_tree_t>::value;
template <typename Pack>
constexpr bool has_region_map = !CGAL::parameters::is_default_parameter<Pack, internal_np::region_map_t>::value;

/// Of a mesh that is segmented once, by the outputs that a pack asks for.
template <typename Pack>
constexpr Preparation preparation_of_pack()
{
  return has_merge_tree<Pack> || has_region_map<Pack> ? Preparation::FOR_ONE_USE : Preparation::FOR_ONE_NUMBER;
}

template <typename FaceGraph, typename FaceSeedMap>
Seeds read_seeds(const FaceGraph& mesh, const FaceSeedMap& map)
{
  static_assert(std::is_integral<typename boost::property_traits<FaceSeedMap>::value_type>::value,
                "face_seed_map has an integral value type; std::size_t(-1) stands for no seed");
  return make_seeds(face_values(mesh, map));
}

template <typename FaceGraph, typename Pack>
Seeds seeds_of_pack(const FaceGraph& mesh, const Pack& np)
{
  if constexpr (has_seeds<Pack>)
    return read_seeds(mesh, CGAL::parameters::get_parameter(np, internal_np::face_seed_map));
  else
    return Seeds();
}

/// Reads a mesh and prepares it by the method of a pack, or else by the default one of its type.
template <typename Method, typename ConcurrencyTag, typename FaceGraph, typename Pack>
Prepared_mesh<Method, ConcurrencyTag> prepare(const Mesh_traversal<FaceGraph, Pack>& traversal, Preparation preparation,
                                              const Pack& np)
{
  static_assert(!(has_seeds<Pack> && Method_traits<Method>::is_partitioning),
                "a method with a GraphPartitioner takes no seeds");
  static_assert(!(has_merge_tree<Pack> && Method_traits<Method>::is_partitioning),
                "a method with a GraphPartitioner has no merge_tree");
  const std::size_t number = number_of_segments(np);
  Seeds seeds = seeds_of_pack(traversal.mesh(), np);
  return Prepared_mesh<Method, ConcurrencyTag>(
    read_flat_mesh<ConcurrencyTag>(traversal, np, required_mesh_data<Method>()), method_of_pack<Method>(np), number,
    std::move(seeds), preparation, np);
}

/// Writes the first regions to the map of a pack, if it has one.
template <typename FaceGraph, typename Pack>
void write_regions(const FaceGraph& mesh, const Partition& regions, const Pack& np)
{
  if constexpr (has_region_map<Pack>)
    write_face_values(mesh, regions, CGAL::parameters::get_parameter(np, internal_np::region_map));
  else
    static_cast<void>(mesh), static_cast<void>(regions), static_cast<void>(np);
}

/// \pre `has_merge_tree`
template <typename Pack>
Merge_tree& merge_tree_of(const Pack& np)
{
  return CGAL::parameters::get_parameter_reference(np, internal_np::merge_tree);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_PREPARE_H
