// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LABEL_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LABEL_COMPONENTS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The connected components of the faces across the dual edges `joins(edge)`. O(F) in practice (inverse Ackermann is
/// replaced by a logarithm at worst).
///
/// In parallel each thread unites the faces of its own range; edges between ranges are processed afterwards.
template <typename Joins, typename ConcurrencyTag>
Partition label_components(const Flat_mesh& flat, const Joins& joins, const Execution<ConcurrencyTag>& execution)
{
  using Index = Flat_mesh::Index;
  constexpr std::size_t size_of_range = blocks_in_range * block_size;
  const std::size_t size = flat.number_of_faces();
  std::vector<std::vector<Index>> between_ranges(number_of_blocks(size, size_of_range));
  Lowest_root_forest forest(size);
  for_each_block(
    execution, size,
    [&](std::size_t range, std::size_t begin, std::size_t end) {
      const std::size_t first_of_range = Execution<ConcurrencyTag>::is_parallel ? begin : 0;
      const std::size_t end_edge = flat.first_edge(end);
      // Edges are sorted by their higher face: at the first one it is its own root, and later its root is known.
      Index face = 0, root = 0;
      for (std::size_t e = flat.first_edge(begin); e < end_edge; ++e) {
        const Index lower = flat.lower_face(e), higher = flat.higher_face(e);
        root = higher == face ? root : higher;
        face = higher;
        if (!joins(e))
          continue;
        if (lower >= first_of_range)
          root = forest.unite_with_root(root, lower);
        else
          between_ranges[range].push_back(Index(e));
      }
    },
    size_of_range);
  for (const auto& edges : between_ranges)
    for (Index e : edges)
      forest.unite(flat.lower_face(e), flat.higher_face(e));
  return forest.take_partition();
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LABEL_COMPONENTS_H
