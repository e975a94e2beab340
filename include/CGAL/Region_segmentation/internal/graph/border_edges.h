// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_BORDER_EDGES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_BORDER_EDGES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The lower face of a dual edge, then its id: since edges are numbered by their higher face, keys are ordered by the
/// lower, then by the higher face.
using Border_key = std::uint64_t;

inline Flat_mesh::Index lower_face_of(Border_key key)
{
  return Flat_mesh::Index(key >> 32);
}

inline Flat_mesh::Index edge_of(Border_key key)
{
  return Flat_mesh::Index(key);
}

/// The dual edges between two regions, by their lower, then by their higher face: the order in which sums run.
///
/// On a noisy mesh of 1 million faces, the graph takes 0.65 to 0.7 of the time where sums run in the order of the edges.
/// (Sorting by counting instead gained 0.13 of it, finding edges without a branch nothing.)
template <typename ConcurrencyTag>
Large_array<Border_key> border_edges(const Flat_mesh& flat, const Partition& regions,
                                     const Execution<ConcurrencyTag>& execution)
{
  const std::size_t size = flat.number_of_edges();
  std::vector<Large_array<Border_key>> found(number_of_blocks(size));
  for_each_block(execution, size, [&](std::size_t block, std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
      if (regions[flat.lower_face(e)] != regions[flat.higher_face(e)])
        found[block].push_back((Border_key(flat.lower_face(e)) << 32) | e);
  });
  Large_array<Border_key> keys;
  for (const auto& of_block : found)
    keys.insert(keys.end(), of_block.begin(), of_block.end());
  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
  return keys;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_BORDER_EDGES_H
