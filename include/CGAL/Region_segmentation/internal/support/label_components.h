// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LABEL_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LABEL_COMPONENTS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Function_ref.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// One byte per adjacency of a surface.
using Edge_marks = Large_array<std::uint8_t>;

/// The connected components of the faces across the adjacencies with none of the marks `barring`.
/// Each thread unites the faces of a range of blocks; adjacencies between two ranges follow at the
/// end.
inline Partition label_components(const Surface& surface, const Edge_marks& marks,
                                  std::uint8_t barring, const Execution& execution)
{
  using Index = Surface::Index;
  constexpr std::size_t size_of_range = blocks_in_range * block_size;
  const std::size_t size = surface.number_of_faces();
  std::vector<std::vector<Index>> between_ranges(number_of_blocks(size, size_of_range));
  Lowest_root_forest forest(size);
  const auto unite_range = [&, mark = marks.data()](std::size_t range, std::size_t begin,
                                                    std::size_t end) {
    const std::size_t first_of_range = execution.is_parallel() ? begin : 0;
    const std::size_t past = surface.first_adjacency(end);
    Index face = 0, root = 0;
    for (std::size_t a = surface.first_adjacency(begin); a < past; ++a) {
      const Index lower = surface.lower_face(a), higher = surface.higher_face(a);
      root = higher == face ? root : higher;
      face = higher;
      if ((mark[a] & barring) != 0)
        continue;
      if (lower >= first_of_range)
        root = forest.unite_with_root(root, lower);
      else
        between_ranges[range].push_back(Index(a));
    }
  };
  for_each_block(execution, size, unite_range, size_of_range);
  for (const auto& adjacencies : between_ranges)
    for (const Index a : adjacencies)
      forest.unite(surface.lower_face(a), surface.higher_face(a));
  return forest.take_partition();
}

/// The connected components of the faces across the adjacencies that `joins(adjacency)`.
inline Partition label_components(const Surface& surface, Function_ref<bool(std::size_t)> joins,
                                  const Execution& execution)
{
  Edge_marks is_barred(surface.number_of_adjacencies());
  for_each_index(execution, is_barred.size(), [&](std::size_t a) { is_barred[a] = !joins(a); });
  return label_components(surface, is_barred, 1, execution);
}

/// The connected components across edges.
inline Partition edge_components(const Surface& surface, const Execution& execution)
{
  return label_components(surface, arrays_of(surface).flags, Surface::SEAM | Surface::LINK,
                          execution);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LABEL_COMPONENTS_H
