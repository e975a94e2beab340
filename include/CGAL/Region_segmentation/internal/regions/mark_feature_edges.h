// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURE_EDGES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURE_EDGES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/regions/Feature_criterion.h>
#include <CGAL/Region_segmentation/internal/support/Edge_marks.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// For each adjacency of a surface whether it is a feature edge by its angle and sign.
inline Edge_marks mark_feature_edges(const Surface& surface, const Feature_criterion& criterion,
                                     const Execution& execution)
{
  Edge_marks is_feature(surface.number_of_adjacencies());
  for_each_block(execution, is_feature.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a)
      is_feature[a] = criterion.has_wanted_sign(surface.flags(a)) && surface.has_angle(a) &&
                      criterion.is_sharp(surface.cosine(a));
  });
  return is_feature;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURE_EDGES_H
