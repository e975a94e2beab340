// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_CONNECTED_PIECES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_CONNECTED_PIECES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The connected pieces of the faces with equal labels, across adjacencies that are not
/// constrained. O(F) in practice.
template <typename Labels>
Partition connected_pieces(const Surface& surface, const Labels& label_of_face,
                           const Constraints& constraints)
{
  const auto joins = [&](std::size_t a) {
    return label_of_face[surface.lower_face(a)] == label_of_face[surface.higher_face(a)] &&
           !constraints[a];
  };
  return label_components(surface, joins, Execution());
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_CONNECTED_PIECES_H
