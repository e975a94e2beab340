// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGION_LABELS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGION_LABELS_H

#include <CGAL/Region_segmentation/internal/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/Large_array.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// One byte a dual edge of a `Flat_mesh`; not zero where the edge is a feature edge. A vector that does not set
/// what it is resized to.
using Edge_marks = internal::Large_array<std::uint8_t>;

/// The region of every face: ids 0 .. number_of_regions - 1, numbered by their first face.
struct Region_labels
{
  std::vector<Flat_mesh::Index> of_face;
  std::size_t number_of_regions = 0;

  /// Of a maker that can split its regions: the face by which a face came to its region (itself for the
  /// first one), and how late. Empty otherwise.
  std::vector<Flat_mesh::Index> predecessor;
  std::vector<double> lateness;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGION_LABELS_H
