// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_SPLIT_AT_CONSTRAINTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_SPLIT_AT_CONSTRAINTS_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/regions/connected_pieces.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The number of pieces of each region.
inline std::vector<std::size_t> number_of_pieces(const Partition& regions, const Partition& pieces)
{
  std::vector<std::size_t> number(regions.number_of_parts());
  Partition::Index next_piece = 0; // pieces are numbered by their first face
  for (std::size_t f = 0; f < regions.size(); ++f)
    if (pieces[f] == next_piece) {
      ++number[regions[f]];
      ++next_piece;
    }
  return number;
}

/// Splits the regions that constrained edges separate: those that have more connected components
/// with these than without. A constrained edge that only ends in a region has no effect. O(F).
inline Partition split_at_constraints(const Surface& surface, const Partition& regions,
                                      const Constraints& constraints)
{
  const Partition pieces = connected_pieces(surface, regions, constraints);
  if (pieces.number_of_parts() == regions.number_of_parts())
    return regions;
  const auto separated = number_of_pieces(regions, pieces);
  const auto connected = number_of_pieces(regions,
                                          connected_pieces(surface, regions, Constraints()));
  std::vector<std::uint64_t> labels(regions.size());
  for (std::size_t f = 0; f < labels.size(); ++f) {
    const bool is_split = separated[regions[f]] > connected[regions[f]];
    labels[f] = (std::uint64_t(regions[f]) << 32) | (is_split ? pieces[f] : 0);
  }
  return Partition::from_labels(labels);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_SPLIT_AT_CONSTRAINTS_H
