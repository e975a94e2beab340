// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPPORT_INTERNAL_ARRAYS_H
#define CGAL_REGION_SEGMENTATION_SUPPORT_INTERNAL_ARRAYS_H

#include <CGAL/Region_segmentation/Support/Large_array.h>

#include <CGAL/Iterator_range.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// An array of items, sorted by the numbers of their groups, in the order of insertion within a
/// group. The algorithm is a counting sort.
///
/// With a sort by comparison, superfacets of 10,000 and of 160,000 faces take 1.2 times as long,
/// and rays at 160,000 faces 1.17 times. (A small vector for each face takes the same time, and 16
/// bytes more per face.)
///
/// The array takes the bytes of the items, and 8 per group.
template <typename Item>
class Grouped_items
{
public:
  Grouped_items()
    : m_first(2, 0)
  {}

  /// Sorts the items for which `for_each(add)` calls `add(group, item)`; `for_each` is called
  /// twice.
  template <typename ForEach>
  Grouped_items(std::size_t number_of_groups, const ForEach& for_each)
    : m_first(number_of_groups + 2, 0)
  {
    // Counts are stored two places further on, so that adding moves each start to its final place.
    for_each([&](std::size_t group, const Item&) { ++m_first[group + 2]; });
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_items.resize(m_first.back());
    for_each([&](std::size_t group, const Item& item) { m_items[m_first[group + 1]++] = item; });
  }

  std::size_t number_of_groups() const { return m_first.size() - 2; }
  const Large_array<Item>& all() const { return m_items; }
  Iterator_range<const Item*> operator[](std::size_t group) const
  {
    return {m_items.data() + m_first[group], m_items.data() + m_first[group + 1]};
  }
  Iterator_range<Item*> operator[](std::size_t group)
  {
    return {m_items.data() + m_first[group], m_items.data() + m_first[group + 1]};
  }

private:
  Large_array<std::size_t> m_first;
  Large_array<Item> m_items;
};

/// Calls `f(item, first)` for each item that equals a lower one, where `first` is the lowest item
/// that it equals. Items are the numbers below 2^32 for which `for_each(add)` calls `add(item,
/// hash)`; equal items have equal hashes.
///
/// Sorting takes O(n log n) for n items if few different items have equal hashes. (With a hash
/// table of points, reading 1 million triangles takes 1.8 times as long, 4 million 2.6 times.)
template <typename ForEach, typename AreEqual, typename F>
void for_each_repetition(std::size_t most_items, const ForEach& for_each, const AreEqual& are_equal,
                         const F& f)
{
  using Item = std::uint32_t;
  using Key = std::uint64_t; // a hash that is folded to 32 bits, and the item
  constexpr int bits = 32;
  Large_array<Key> keys;
  keys.reserve(most_items);
  for_each([&](std::size_t item, std::uint64_t hash) { // a hash has 32 or 64 bits
    keys.push_back((hash ^ hash >> bits) << bits | Key(item));
  });
  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
  std::vector<Item> distinct; // different items of the same hash
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

/// The numbers 0 .. `size` - 1 in the order of `less(i, j)`. This sort is compiled once, and slower
/// than one that is compiled for its order.
inline std::vector<std::uint32_t>
sorted_indices(std::size_t size, const std::function<bool(std::uint32_t, std::uint32_t)>& less)
{
  std::vector<std::uint32_t> result(size);
  std::iota(result.begin(), result.end(), std::uint32_t(0));
  std::sort(result.begin(), result.end(), [&](auto i, auto j) { return less(i, j); });
  return result;
}

/// A non-negative float and an index as one number, ordered by the float, then by the index: it is
/// compared without a branch, and exchanged between threads at once. (The bits of such floats are
/// ordered like their values.)
using Float_key = std::uint64_t;

inline Float_key make_float_key(float value, std::uint32_t index)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return (Float_key(bits) << 32) | index;
}

inline std::uint32_t index_of(Float_key key)
{
  return std::uint32_t(key);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPPORT_INTERNAL_ARRAYS_H
