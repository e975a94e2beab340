// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_METHOD_CALLS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_METHOD_CALLS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Hierarchy.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/support/compiled.h>
#include <CGAL/Region_segmentation/internal/support/satisfies.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename Method>
using Prepared_by = decltype(std::declval<const Method&>().prepare(
  std::declval<const Surface&>(), std::declval<const Execution&>()));
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

template <typename Method>
using Is_method = std::enable_if_t<std::is_base_of<Hierarchy, Merged_by<Method>>::value>;

template <typename Method>
constexpr bool check_method()
{
  static_assert(
    satisfies<Is_method, Method>,
    "a SegmentationMethod needs: Prepared prepare(const Surface&, const Execution&) const, and "
    "Hierarchy or Segmentation merge(const Surface&, const Prepared&, const Request&, const "
    "Execution&) const. (The default method needs #include <CGAL/region_segmentation.h>)");
  return true;
}

/// All that is called of a method. Members are defined outside of the class, thus not inline, so
/// that `extern template` keeps them out of a translation unit (see `compiled.h`).
template <typename Method>
struct Method_calls
{
  using Prepared = Prepared_by<Method>;
  using Merged = Merged_by<Method>;

  static Prepared prepare(const Method& method, const Surface& surface, const Execution& execution);

  /// \throws Invalid_method if regions and tree do not fit the surface
  static Merged merge(const Method& method, const Surface& surface, const Prepared& prepared,
                      const Request& request, const Execution& execution);

  static Composed_partition segments(const Merged& merged, const Surface& surface,
                                     std::size_t number);
};

template <typename Method>
Prepared_by<Method> Method_calls<Method>::prepare(const Method& method, const Surface& surface,
                                                  const Execution& execution)
{
  return method.prepare(surface, execution);
}

template <typename Method>
Merged_by<Method> Method_calls<Method>::merge(const Method& method, const Surface& surface,
                                              const Prepared& prepared, const Request& request,
                                              const Execution& execution)
{
  Merged result = method.merge(surface, prepared, request, execution);
  const Partition& regions = result.regions();
  const std::size_t number_of_regions = result.merge_tree().number_of_regions();
  check_regions(regions, surface.number_of_faces());
  if (regions.number_of_parts() != number_of_regions)
    throw Invalid_method("merge() of the SegmentationMethod returns " +
                         std::to_string(regions.number_of_parts()) + " regions, and merges " +
                         std::to_string(number_of_regions));
  return result;
}

template <typename Method>
Composed_partition Method_calls<Method>::segments(const Merged& merged, const Surface& surface,
                                                  std::size_t number)
{
  return merged.segments(surface, number);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_METHOD_CALLS_H
