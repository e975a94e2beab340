// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_DIVIDE_PARTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_DIVIDE_PARTS_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The adjacencies with a face in one of the parts that are `wanted`.
inline std::vector<Surface::Index> adjacencies_of_parts(const Surface& surface,
                                                        const Partition& parts,
                                                        const std::vector<std::uint8_t>& wanted)
{
  std::vector<Surface::Index> result;
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (wanted[parts[surface.lower_face(a)]] | wanted[parts[surface.higher_face(a)]])
      result.push_back(Surface::Index(a));
  return result;
}

/// Divides some parts of the faces, those that are `divided`, into their connected pieces across
/// those of the given adjacencies that `joins(adjacency)`. The others stay as they are. O(F).
template <typename Joins>
Partition divide_parts(const Surface& surface, const Partition& parts,
                       const std::vector<std::uint8_t>& divided,
                       const std::vector<Surface::Index>& adjacencies, const Joins& joins)
{
  using Index = Partition::Index;
  constexpr Index none = (std::numeric_limits<Index>::max)();
  std::vector<Index> first_of(parts.number_of_parts(), none);
  Partition::Numbers roots;
  roots.reserve(parts.size());
  for (Index f = 0; f < parts.size(); ++f) {
    Index& first = first_of[parts[f]];
    first = first == none || divided[parts[f]] ? f : first;
    roots.push_back(first);
  }
  Lowest_root_forest forest(std::move(roots));
  for (const Index a : adjacencies) {
    const Index f = surface.lower_face(a), g = surface.higher_face(a);
    if (parts[f] == parts[g] && divided[parts[f]] && joins(a))
      forest.unite(f, g);
  }
  return forest.take_partition();
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_DIVIDE_PARTS_H
