// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_RUN_METHOD_H
#define CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_RUN_METHOD_H

#include <CGAL/Region_segmentation/Graph/Hierarchy.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Support/version.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/smooth_noise.h>
#include <CGAL/Region_segmentation/Surface/internal/voids.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename Method>
using Prepared_by = decltype(std::declval<const Method&>().prepare(
  std::declval<const Surface&>(), std::size_t(), std::declval<const Execution&>()));
template <typename Method>
using Merged_by = decltype(std::declval<const Method&>().merge(
  std::declval<const Surface&>(), std::declval<const Prepared_by<Method>&>(),
  std::declval<const Request&>(), std::declval<const Execution&>()));

/// Whether the order of merges of a method depends on the number of segments.
template <typename Method>
constexpr bool needs_number()
{
  return std::is_base_of<Segmentation, Merged_by<Method>>::value;
}

/// The constant of a method that segments surfaces without their voids.
template <typename Method>
using Fills_voids = std::enable_if_t<Method::fills_voids>;
/// The constant of a method that segments surfaces without their noise.
template <typename Method>
using Smooths_noise = std::enable_if_t<Method::smooths_noise>;

template <typename Method>
using Is_method = std::enable_if_t<std::is_base_of<Hierarchy, Merged_by<Method>>::value>;

template <typename Method>
constexpr bool check_method()
{
  static_assert(
    satisfies<Is_method, Method>,
    "a SegmentationMethod needs: Prepared prepare(const Surface&, std::size_t number_of_segments, "
    "const Execution&) const, and Hierarchy or Segmentation merge(const Surface&, const Prepared&, "
    "const Request&, const Execution&) const. (The default method needs #include "
    "<CGAL/region_segmentation.h>)");
  return true;
}

/// The request for a surface whose voids are filled. The seed of a face of a void is that of the
/// face of the filled surface.
/// \throws Invalid_input if two seeds would be that of the same face
inline Request request_of_filled(Request request, const Filled_surface& filled)
{
  if (request.seeds.empty())
    return request;
  std::vector<Seeds::Index> seeds(filled.surface.number_of_faces(), Seeds::none);
  for (std::size_t f = 0; f < filled.faces.size(); ++f)
    if (const Seeds::Index seed = request.seeds.of[f]; seed != Seeds::none) {
      const Seeds::Index other = std::exchange(seeds[filled.faces[f]], seed);
      if (other != Seeds::none && other != seed)
        throw Invalid_input("the seeds " + std::to_string(request.seeds.values[other]) + " and " +
                            std::to_string(request.seeds.values[seed]) +
                            " are at one place of the wall of a void");
    }
  request.seeds.of = std::move(seeds);
  return request;
}

/// The calls of a method. Members are defined outside of the class and are not inline, so that
/// `extern template` keeps them out of a translation unit (see `version.h`).
template <typename Method>
struct Method_calls
{
  struct Prepared
  {
    std::shared_ptr<const Filled_surface> filled; ///< what the method is given; null: the surface
    Prepared_by<Method> by_method;
  };
  using Merged = Merged_by<Method>;

  /// The surface as the method sees it: without noise, if the method smooths it.
  static Surface smoothed(Surface surface, const Execution& execution);

  /// `number`: the number of segments that was given; 0: none
  static Prepared prepare(const Method& method, const Surface& surface, std::size_t number,
                          const Execution& execution);

  /// \throws Invalid_method if regions and tree do not fit the surface
  static Merged merge(const Method& method, const Surface& surface, const Prepared& prepared,
                      const Request& request, const Execution& execution);
};

template <typename Method>
Surface Method_calls<Method>::smoothed(Surface surface, [[maybe_unused]] const Execution& execution)
{
  if constexpr (satisfies<Smooths_noise, Method>)
    surface = without_noise(std::move(surface), execution.stage("regions").step(0, 0));
  return surface;
}

template <typename Method>
typename Method_calls<Method>::Prepared
Method_calls<Method>::prepare(const Method& method, const Surface& surface, std::size_t number,
                              const Execution& execution)
{
  std::shared_ptr<const Filled_surface> filled;
  if constexpr (satisfies<Fills_voids, Method>)
    if (surface.has_voids())
      filled = std::make_shared<const Filled_surface>(
        fill_voids(surface, execution.stage("regions").step(0, 0)));
  return {filled, method.prepare(filled ? filled->surface : surface, number, execution)};
}

template <typename Method>
Merged_by<Method> Method_calls<Method>::merge(const Method& method, const Surface& surface,
                                              const Prepared& prepared, const Request& request,
                                              const Execution& execution)
{
  const auto& filled = prepared.filled;
  const Surface& seen = filled ? filled->surface : surface;
  Merged result = method.merge(seen, prepared.by_method,
                               filled ? request_of_filled(request, *filled) : request, execution);
  const Partition& regions = result.regions();
  const std::size_t number_of_regions = result.merge_tree().number_of_regions();
  check_regions(regions, seen.number_of_faces());
  if (regions.number_of_parts() != number_of_regions)
    throw Invalid_method("merge() of the SegmentationMethod returns " +
                         std::to_string(regions.number_of_parts()) + " regions, and merges " +
                         std::to_string(number_of_regions));
  if (!filled)
    return result;
  std::vector<Partition::Index> region_of;
  for (const Surface::Index f : filled->faces)
    region_of.push_back(regions[f]);
  static_cast<Hierarchy&>(result) = renumbered_hierarchy(region_of, result.merge_tree(),
                                                         result.number_of_segments());
  return result;
}

} // namespace internal

struct Learned_merging;

namespace internal {

/// The type of the method in a pack of named parameters, or of the default method.
template <typename Pack>
using Method_of_pack = std::decay_t<typename CGAL::internal_np::Lookup_named_param_def<
  internal_np::method_t, Pack, Learned_merging>::type>;

template <typename NamedParameters>
using Method_of_parameters = Method_of_pack<
  std::decay_t<decltype(pack(std::declval<const NamedParameters&>()))>>;

/// Returns the method in a pack of named parameters, which need not be default constructible, or
/// the default method.
template <typename Method, typename Pack>
Method method_of_pack(const Pack& np)
{
  if constexpr (!has_parameter<Pack, internal_np::method_t>)
    return Method();
  else {
    using Given = std::decay_t<decltype(CGAL::parameters::get_parameter(np, internal_np::method))>;
    static_assert(std::is_convertible<Given, Method>::value,
                  "the Segmenter is of another type than the method: omit its template arguments, "
                  "which are deduced in "
                  "Segmenter segmenter(mesh, parameters::method(m))");
    return CGAL::parameters::get_parameter(np, internal_np::method);
  }
}

template <typename Input>
using Segmenting_parameters = Tag_list<
  internal_np::number_of_segments_t, internal_np::method_t, internal_np::face_seed_map_t,
  internal_np::component_links_t, internal_np::region_map_t, internal_np::merge_tree_t,
  std::decay_t<decltype(Input::constraints)>, CGAL::internal_np::visitor_t>;

/// Reads seeds from a map.
template <typename Input, typename SeedMap>
Seeds read_seeds(const Input& input, const SeedMap& map)
{
  const auto values = input.values(map);
  static_assert(std::is_integral<typename std::decay_t<decltype(values)>::value_type>::value,
                "face_seed_map has an integral value type; -1 of it stands for no seed");
  return Seeds::from_values(values);
}

/// The request in a pack of named parameters.
template <typename Input, typename Pack>
Request request_of_pack(const Input& input, const Pack& np)
{
  Request request;
  if constexpr (has_parameter<Pack, internal_np::number_of_segments_t>) {
    const auto k = CGAL::parameters::get_parameter(np, internal_np::number_of_segments);
    CGAL_precondition_msg(k >= 1, "number_of_segments is at least 1");
    request.number_of_segments = std::size_t(k);
  }
  if constexpr (has_parameter<Pack, internal_np::face_seed_map_t>)
    request.seeds = read_seeds(input,
                               CGAL::parameters::get_parameter(np, internal_np::face_seed_map));
  return request;
}

template <typename Pack>
constexpr bool has_outputs = has_parameter<Pack, internal_np::region_map_t> ||
                             has_parameter<Pack, internal_np::merge_tree_t>;

/// Writes the outputs that a pack of named parameters names: regions and merge tree.
template <typename Input, typename Pack>
void write_outputs([[maybe_unused]] const Input& input, [[maybe_unused]] const Hierarchy& result,
                   [[maybe_unused]] const Pack& np)
{
  if constexpr (has_parameter<Pack, internal_np::region_map_t>)
    input.write(result.regions(),
                CGAL::parameters::get_parameter_reference(np, internal_np::region_map));
  if constexpr (has_parameter<Pack, internal_np::merge_tree_t>)
    CGAL::parameters::get_parameter_reference(np, internal_np::merge_tree) = result.merge_tree();
}

/// Segments a surface once, and writes labels and outputs. Returns the number of segments.
template <typename Input, typename SegmentMap, typename Pack>
std::size_t run_method(const Input& input, Surface surface, SegmentMap& segment_map, const Pack& np,
                       const Execution& execution)
{
  using Method = Method_of_pack<Pack>;
  check_parameters<Pack, Segmenting_parameters<Input>>();
  static_assert(check_method<Method>());
  static_assert(!needs_number<Method>() || has_parameter<Pack, internal_np::number_of_segments_t>,
                "segment() with this method needs the named parameter number_of_segments");
  input.check(segment_map, 0);
  const Method method = method_of_pack<Method>(np);
  using Calls = Method_calls<Method>;
  surface = Calls::smoothed(constrained(input, std::move(surface), np), execution);
  Request request = request_of_pack(input, np);
  request.needs_all_numbers = has_outputs<Pack>;
  const auto prepared = Calls::prepare(method, surface, request.number_of_segments, execution);
  const auto result = Calls::merge(method, surface, prepared, request, execution);
  const Partition segments = result.segments(result.number_of_segments());
  if constexpr (has_parameter<Pack, internal_np::region_map_t>)
    input.check(CGAL::parameters::get_parameter_reference(np, internal_np::region_map),
                result.regions().number_of_parts(), "first region");
  input.write(segments, segment_map);
  write_outputs(input, result, np);
  return segments.number_of_parts();
}

} // namespace internal

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_RUN_METHOD_H
