// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_PAIR_INDEX_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_PAIR_INDEX_H

#include <CGAL/Region_segmentation/internal/Large_array.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds the item that joins two numbers, for items that know their own two numbers: an open-addressing
/// hash table of item ids alone, at most two thirds full, 6 to 12 bytes an item. (A node-based map
/// takes ten times the memory and an allocation for each item.)
///
/// `Ends(item)` gives the pair of numbers of an item in the table, in either order. An item must be
/// erased before its numbers change. The hash does not depend on addresses.
class Pair_index
{
public:
  using Id = std::uint32_t;
  using Pair = std::pair<Id, Id>;
  static constexpr Id none = (std::numeric_limits<Id>::max)();

  template <typename Ends>
  Id find(Pair pair, const Ends& ends) const
  {
    return m_cells.empty() ? none : m_cells[position(pair, ends)];
  }

  /// \pre no item with these numbers is in the table
  template <typename Ends>
  void insert(Id item, const Ends& ends)
  {
    if (3 * (m_size + 1) > 2 * m_cells.size())
      grow(ends);
    m_cells[position(ends(item), ends)] = item;
    ++m_size;
  }

  /// \pre the item is in the table
  template <typename Ends>
  void erase(Id item, const Ends& ends)
  {
    std::size_t hole = position(ends(item), ends);
    // Later items of the run move up, unless that would put them before their own start.
    for (std::size_t i = following(hole); m_cells[i] != none; i = following(i)) {
      const std::size_t start = hash(ends(m_cells[i])) & mask();
      if (((i - start) & mask()) >= ((i - hole) & mask())) {
        m_cells[hole] = m_cells[i];
        hole = i;
      }
    }
    m_cells[hole] = none;
    --m_size;
  }

private:
  static Pair sorted(Pair p) { return p.first <= p.second ? p : Pair(p.second, p.first); }

  /// The finalizer of MurmurHash3 (public domain) on the two numbers as one.
  static std::size_t hash(Pair p)
  {
    p = sorted(p);
    std::uint64_t x = (std::uint64_t(p.first) << 32) | p.second;
    x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdULL;
    x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return std::size_t(x ^ (x >> 33));
  }

  std::size_t mask() const { return m_cells.size() - 1; }
  std::size_t following(std::size_t i) const { return (i + 1) & mask(); }

  /// Where the pair is, or the free cell where it would be.
  template <typename Ends>
  std::size_t position(Pair pair, const Ends& ends) const
  {
    std::size_t i = hash(pair) & mask();
    while (m_cells[i] != none && sorted(ends(m_cells[i])) != sorted(pair))
      i = following(i);
    return i;
  }

  template <typename Ends>
  void grow(const Ends& ends)
  {
    Large_array<Id> items = std::move(m_cells);
    m_cells.assign(items.empty() ? 16 : 2 * items.size(), none);
    for (Id item : items)
      if (item != none)
        m_cells[position(ends(item), ends)] = item;
  }

  Large_array<Id> m_cells;
  std::size_t m_size = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_PAIR_INDEX_H
