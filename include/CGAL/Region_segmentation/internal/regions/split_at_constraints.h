// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_SPLIT_AT_CONSTRAINTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_SPLIT_AT_CONSTRAINTS_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/internal/support/divide_parts.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The pieces of regions, those of a region that is not `split` joined again.
inline Partition joined_unless_split(const Partition& pieces, const Partition& regions,
                                     const std::vector<std::uint8_t>& split)
{
  std::size_t face = 0;
  return Partition::from_labels(pieces, pieces.size(), [&](Partition::Index piece) {
    const Partition::Index region = regions[face++];
    return split[region] ? std::uint64_t(regions.number_of_parts()) + piece : region;
  });
}

/// Splits the regions that constrained edges separate: those that have more connected components
/// with these than without. A constrained edge that only ends in a region has no effect. O(F).
inline Partition split_at_constraints(const Surface& surface, const Partition& regions,
                                      const Constraints& constraints)
{
  std::vector<Surface::Index> inner; // constrained, and in one region
  std::vector<std::uint8_t> crossed(regions.number_of_parts()), split(regions.number_of_parts());
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (constraints[a] && regions[surface.lower_face(a)] == regions[surface.higher_face(a)]) {
      inner.push_back(Surface::Index(a));
      crossed[regions[surface.lower_face(a)]] = 1;
    }
  Partition pieces = divide_parts(surface, regions, crossed,
                                  adjacencies_of_parts(surface, regions, crossed),
                                  [&](std::size_t a) { return !constraints[a]; });
  for (const Surface::Index a : inner)
    if (pieces[surface.lower_face(a)] != pieces[surface.higher_face(a)])
      split[regions[surface.lower_face(a)]] = 1;
  return joined_unless_split(std::move(pieces), regions, split);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_SPLIT_AT_CONSTRAINTS_H
