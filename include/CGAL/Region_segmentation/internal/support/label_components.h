// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LABEL_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LABEL_COMPONENTS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The connected components of the faces across the adjacencies that `joins(adjacency)`. Each
/// thread unites the faces of a range of blocks; adjacencies between two ranges follow at the end.
template <typename Joins>
Partition label_components(const Surface& surface, const Joins& joins, const Execution& execution)
{
  using Index = Surface::Index;
  constexpr std::size_t size_of_range = blocks_in_range * block_size;
  const std::size_t size = surface.number_of_faces();
  std::vector<std::vector<Index>> between_ranges(number_of_blocks(size, size_of_range));
  Lowest_root_forest forest(size);
  for_each_block(
    execution, size,
    [&](std::size_t range, std::size_t begin, std::size_t end) {
      const std::size_t first_of_range = execution.is_parallel() ? begin : 0;
      const std::size_t past = surface.first_adjacency(end);
      Index face = 0, root = 0;
      for (std::size_t a = surface.first_adjacency(begin); a < past; ++a) {
        const Index lower = surface.lower_face(a), higher = surface.higher_face(a);
        root = higher == face ? root : higher;
        face = higher;
        if (!joins(a))
          continue;
        if (lower >= first_of_range)
          root = forest.unite_with_root(root, lower);
        else
          between_ranges[range].push_back(Index(a));
      }
    },
    size_of_range);
  for (const auto& adjacencies : between_ranges)
    for (const Index a : adjacencies)
      forest.unite(surface.lower_face(a), surface.higher_face(a));
  return forest.take_partition();
}

/// The connected components across edges.
inline Partition edge_components(const Surface& surface, const Execution& execution)
{
  return label_components(
    surface, [&](std::size_t a) { return !surface.has_flag(a, Surface::SEAM | Surface::LINK); },
    execution);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LABEL_COMPONENTS_H
