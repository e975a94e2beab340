// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FOR_EACH_REPETITION_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FOR_EACH_REPETITION_H

#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(item, first)` for each item that equals a lower one, with the lowest of those. The
/// items are the numbers below 2^32 for which `for_each(add)` calls `add(item, hash)`; equal ones
/// have equal hashes.
///
/// O(n log n) for n items if few different ones have equal hashes, by sorting. (With a hash table
/// of the points, reading takes 1.8 times as long at 1 million triangles, 2.6 times at 4 million.)
template <typename ForEach, typename AreEqual, typename F>
void for_each_repetition(std::size_t most_items, const ForEach& for_each, const AreEqual& are_equal,
                         const F& f)
{
  using Item = std::uint32_t;
  using Key = std::uint64_t; // a hash folded to 32 bits, and the item
  constexpr int bits = 32;
  Large_array<Key> keys;
  keys.reserve(most_items);
  for_each([&](std::size_t item, std::uint64_t hash) { // of 32 or 64 bits
    keys.push_back((hash ^ hash >> bits) << bits | Key(item));
  });
  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
  std::vector<Item> distinct; // those of a hash
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i > 0 && keys[i] >> bits != keys[i - 1] >> bits)
      distinct.clear();
    const Item item = Item(keys[i]);
    const auto first = std::find_if(distinct.begin(), distinct.end(),
                                    [&](Item other) { return are_equal(other, item); });
    if (first == distinct.end())
      distinct.push_back(item);
    else
      f(item, *first);
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FOR_EACH_REPETITION_H
