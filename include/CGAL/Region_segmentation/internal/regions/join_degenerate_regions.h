// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_JOIN_DEGENERATE_REGIONS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_JOIN_DEGENERATE_REGIONS_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The number of faces that are not degenerate.
inline std::size_t number_of_proper_faces(const Surface& surface)
{
  std::size_t number = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    number += !surface.is_degenerate(f);
  return number;
}

/// Joins regions so that none consists of degenerate faces alone, if possible: across the edges
/// that join these, then across their other edges.
inline Partition join_degenerate_regions(const Surface& surface, const Partition& regions)
{
  std::vector<bool> is_proper(regions.number_of_parts()); // by root
  for (std::size_t f = 0; f < regions.size(); ++f)
    if (!surface.is_degenerate(f))
      is_proper[regions[f]] = true;
  if (std::find(is_proper.begin(), is_proper.end(), false) == is_proper.end())
    return regions;
  Lowest_root_forest forest(is_proper.size());
  for (const std::uint8_t flag : {Surface::JOINING, Surface::CLOSED})
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
      const auto r = forest.root(regions[surface.lower_face(a)]),
                 s = forest.root(regions[surface.higher_face(a)]);
      if (!surface.has_flag(a, flag) || surface.has_flag(a, Surface::CONSTRAINED) ||
          (is_proper[r] && is_proper[s]))
        continue;
      is_proper[(std::min)(r, s)] = is_proper[r] || is_proper[s];
      forest.unite(r, s);
    }
  return composed(regions, forest.take_partition());
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_JOIN_DEGENERATE_REGIONS_H
