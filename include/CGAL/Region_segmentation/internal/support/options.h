// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_OPTIONS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_OPTIONS_H

#include <CGAL/Region_segmentation/Feature_convexity.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/assertions.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename Pack>
double maximum_angle(const Pack& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const double degrees = choose_parameter(get_parameter(np, CGAL::internal_np::maximum_angle),
                                          default_maximum_angle);
  CGAL_precondition_msg(degrees >= 0 && degrees <= 180, "maximum_angle is in [0, 180] degrees");
  return degrees;
}

template <typename Pack>
Feature_convexity feature_convexity(const Pack& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return choose_parameter(get_parameter(np, internal_np::feature_convexity),
                          Feature_convexity::CONCAVE);
}

/// The wanted number of segments; 0 if the pack has none.
template <typename Pack>
std::size_t number_of_segments(const Pack& np)
{
  if constexpr (has_parameter<Pack, internal_np::number_of_segments_t>) {
    const auto k = CGAL::parameters::get_parameter(np, internal_np::number_of_segments);
    CGAL_precondition_msg(k >= 1, "number_of_segments is at least 1");
    return std::size_t(k);
  } else
    return 0;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_OPTIONS_H
