// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_BORDER_EDGES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_BORDER_EDGES_H

#include <CGAL/Region_segmentation/internal/Large_array.h>
#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The lower face of a dual edge, then its id: edges are sorted by their higher face.
using Border_key = std::uint64_t;

/// Appends the keys of those edges `begin` .. `end - 1` that are between two regions; at most `block_size` are looked
/// at. On a noisy mesh nobody could predict which these are: so there is no branch.
inline void append_border_keys(const Flat_mesh& flat, const Region_labels& regions, std::size_t begin, std::size_t end,
                               Large_array<Border_key>& keys)
{
  std::array<Border_key, block_size> found;
  const Flat_mesh::Index* const region = regions.of_face.data();
  std::size_t n = 0;
  for (std::size_t e = begin; e < end; ++e) {
    const Flat_mesh::Index lower = flat.lower_face(e);
    found[n] = (Border_key(lower) << 32) | e;
    n += region[lower] != region[flat.higher_face(e)];
  }
  keys.insert(keys.end(), found.begin(), found.begin() + std::ptrdiff_t(n));
}

/// The dual edges between two regions, by their lower, then by their higher face: the order in which sums run.
template <typename ConcurrencyTag>
Large_array<Flat_mesh::Index> border_edges(const Flat_mesh& flat, const Region_labels& regions)
{
  const std::size_t size = flat.number_of_edges();
  Large_array<Border_key> keys;
  if constexpr (is_parallel<ConcurrencyTag>) {
    std::vector<Large_array<Border_key>> found(number_of_blocks(size));
    for_each_block<ConcurrencyTag>(size, [&](std::size_t block, std::size_t begin, std::size_t end) {
      append_border_keys(flat, regions, begin, end, found[block]);
    });
    for (const auto& of_block : found)
      keys.insert(keys.end(), of_block.begin(), of_block.end());
  } else
    for_each_block<ConcurrencyTag>(size, [&](std::size_t, std::size_t begin, std::size_t end) {
      append_border_keys(flat, regions, begin, end, keys);
    });

  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
  Large_array<Flat_mesh::Index> edges(keys.size());
  std::transform(keys.begin(), keys.end(), edges.begin(), [](Border_key key) { return Flat_mesh::Index(key); });
  return edges;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_BORDER_EDGES_H
