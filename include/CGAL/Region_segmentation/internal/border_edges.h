// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_BORDER_EDGES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_BORDER_EDGES_H

#include <CGAL/Region_segmentation/internal/Large_array.h>
#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The dual edges between two regions, by their lower, then by their higher face: the order in which sums run.
template <typename ConcurrencyTag>
Large_array<Flat_mesh::Index> border_edges(const Flat_mesh& flat, const Region_labels& regions)
{
  using Key = std::uint64_t; // the lower face, then the edge: edges are sorted by their higher face
  std::vector<Large_array<Key>> found(is_parallel<ConcurrencyTag> ? number_of_blocks(flat.number_of_edges()) : 1);
  for_each_block<ConcurrencyTag>(
    flat.number_of_edges(), [&](std::size_t block, std::size_t begin, std::size_t end) {
      Large_array<Key>& keys = found[is_parallel<ConcurrencyTag> ? block : 0];
      for (std::size_t e = begin; e < end; ++e)
        if (regions.of_face[flat.lower_face(e)] != regions.of_face[flat.higher_face(e)])
          keys.push_back((Key(flat.lower_face(e)) << 32) | e);
    });
  for (std::size_t block = 1; block < found.size(); ++block)
    found[0].insert(found[0].end(), found[block].begin(), found[block].end());

  Large_array<Flat_mesh::Index> edges;
  if (found.empty())
    return edges;
  boost::sort::spreadsort::integer_sort(found[0].begin(), found[0].end());
  edges.reserve(found[0].size());
  for (const Key key : found[0])
    edges.push_back(Flat_mesh::Index(key));
  return edges;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_BORDER_EDGES_H
