// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_BORDER_EDGES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_BORDER_EDGES_H

#include <CGAL/Region_segmentation/internal/Large_array.h>
#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
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

/// The edges by their lower, then by their higher face, of keys by the higher one. Few are sorted, many counted.
inline Large_array<Flat_mesh::Index> edges_by_lower_face(Large_array<Border_key> keys, std::size_t number_of_faces)
{
  Large_array<Flat_mesh::Index> edges(keys.size());
  if (keys.size() < number_of_faces / 16) {
    std::sort(keys.begin(), keys.end());
    std::transform(keys.begin(), keys.end(), edges.begin(), [](Border_key key) { return Flat_mesh::Index(key); });
    return edges;
  }
  std::vector<Flat_mesh::Index> places(number_of_faces + 1); // of the next edge of a face
  for (const Border_key key : keys)
    ++places[(key >> 32) + 1];
  std::partial_sum(places.begin(), places.end(), places.begin());
  for (const Border_key key : keys)
    edges[places[key >> 32]++] = Flat_mesh::Index(key);
  return edges;
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

  return edges_by_lower_face(std::move(keys), flat.number_of_faces());
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_BORDER_EDGES_H
