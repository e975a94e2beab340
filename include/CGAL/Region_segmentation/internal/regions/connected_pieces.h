// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_CONNECTED_PIECES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_CONNECTED_PIECES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The connected pieces of the faces with equal labels, across those dual edges that `is_crossed(edge)`. O(F) in
/// practice.
template <typename Labels, typename IsCrossed>
Partition connected_pieces(const Flat_mesh& flat, const Labels& label_of_face, const IsCrossed& is_crossed)
{
  const auto joins = [&](std::size_t e) {
    return label_of_face[flat.lower_face(e)] == label_of_face[flat.higher_face(e)] && is_crossed(e);
  };
  return label_components(flat, joins, Execution<>());
}

/// The same across the edges that are not constrained.
template <typename Labels>
Partition connected_pieces(const Flat_mesh& flat, const Labels& label_of_face)
{
  return connected_pieces(flat, label_of_face,
                          [&](std::size_t e) { return !flat.has_flag(e, Flat_mesh::CONSTRAINED); });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_CONNECTED_PIECES_H
