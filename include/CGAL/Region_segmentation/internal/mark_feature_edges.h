// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_MARK_FEATURE_EDGES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_MARK_FEATURE_EDGES_H

#include <CGAL/Region_segmentation/Feature_convexity.h>
#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Marks the dual edges whose deviation is above `maximum_angle` (degrees) and whose sign is wanted,
/// and the constrained ones. Only cosines are compared. O(F).
template <typename ConcurrencyTag = CGAL::Sequential_tag>
Edge_marks mark_feature_edges(const Flat_mesh& flat, double maximum_angle, Feature_convexity convexity)
{
  // Nothing deviates by more than 180 degrees, though a cosine may be rounded to less than -1.
  const double bound = maximum_angle < 180 ? std::cos(maximum_angle * (CGAL_PI / 180))
                                           : -std::numeric_limits<double>::infinity();
  const int any_sign = convexity == Feature_convexity::ALL;
  const int wanted = convexity == Feature_convexity::CONVEX ? Flat_mesh::CONVEX : Flat_mesh::CONCAVE;

  const Vector_3* const normals = flat.normals();
  const Flat_mesh::Index *const lower = flat.lower_faces(), *const higher = flat.higher_faces();
  const std::uint8_t* const edge_flags = flat.edge_flags();
  Edge_marks is_feature(flat.number_of_edges());
  std::uint8_t* const marks = is_feature.data();
  for_each_block<ConcurrencyTag>(
    flat.number_of_edges(), [=](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e) {
        // No branch: the sign of an edge cannot be predicted.
        const int flags = edge_flags[e];
        const int has_sign = any_sign | ((flags & wanted) != 0);
        const int has_angle = (flags & (Flat_mesh::JOINING | Flat_mesh::CLOSED)) == 0;
        const int is_sharp = dot(normals[lower[e]], normals[higher[e]]) < bound;
        const int is_constrained = (flags & Flat_mesh::CONSTRAINED) != 0;
        marks[e] = std::uint8_t((has_sign & has_angle & is_sharp) | is_constrained);
      }
    });
  return is_feature;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_MARK_FEATURE_EDGES_H
