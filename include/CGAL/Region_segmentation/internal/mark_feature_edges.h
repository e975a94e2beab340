// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_MARK_FEATURE_EDGES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_MARK_FEATURE_EDGES_H

#include <CGAL/Region_segmentation/Feature_convexity.h>
#include <CGAL/Region_segmentation/internal/Region_labels.h>

#include <CGAL/number_type_config.h>

#include <cmath>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Marks the dual edges whose deviation is above `maximum_angle` (degrees) and whose sign is wanted,
/// and the constrained ones. Only cosines are compared. O(F).
inline Edge_marks mark_feature_edges(const Flat_mesh& flat, double maximum_angle,
                                     Feature_convexity convexity)
{
  const double bound = std::cos(maximum_angle * (CGAL_PI / 180));
  const bool any_sign = convexity == Feature_convexity::ALL;
  const std::uint8_t wanted =
    convexity == Feature_convexity::CONVEX ? Flat_mesh::CONVEX : Flat_mesh::CONCAVE;

  Edge_marks is_feature(flat.number_of_edges());
  for (std::size_t f = 0; f < flat.number_of_faces(); ++f)
    for (std::size_t e = flat.first_edge(f); e < flat.first_edge(f + 1); ++e) {
      const bool is_sharp = (any_sign || flat.has_flag(e, wanted)) &&
                            !flat.has_flag(e, Flat_mesh::JOINING | Flat_mesh::CLOSED) &&
                            flat.cosine(f, e) < bound;
      is_feature[e] = is_sharp || flat.has_flag(e, Flat_mesh::CONSTRAINED);
    }
  return is_feature;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_MARK_FEATURE_EDGES_H
