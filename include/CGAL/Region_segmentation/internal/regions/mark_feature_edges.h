// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURE_EDGES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURE_EDGES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Feature_convexity.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Marks the adjacencies whose deviation is above `maximum_angle`, in degrees, and whose sign is
/// wanted: feature edges.
inline Edge_marks mark_feature_edges(const Surface& surface, double maximum_angle,
                                     Feature_convexity convexity, const Execution& execution)
{
  const double bound = std::cos(maximum_angle * (CGAL_PI / 180));
  const std::uint8_t wanted_signs = convexity == Feature_convexity::CONVEX    ? Surface::CONVEX
                                    : convexity == Feature_convexity::CONCAVE ? Surface::CONCAVE
                                                                              : 0; // whatever the
                                                                                   // sign
  Edge_marks is_feature(surface.number_of_adjacencies());
  for_each_block(execution, is_feature.size(),
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t a = begin; a < end; ++a)
                     is_feature[a] = (wanted_signs == 0 || surface.has_flag(a, wanted_signs)) &&
                                     surface.has_angle(a) && surface.cosine(a) < bound;
                 });
  return is_feature;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURE_EDGES_H
