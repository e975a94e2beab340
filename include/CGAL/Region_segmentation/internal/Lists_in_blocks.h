// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_LISTS_IN_BLOCKS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_LISTS_IN_BLOCKS_H

#include <CGAL/Region_segmentation/internal/Large_array.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Lists of numbers, each in the order in which they came, in blocks of one array: a short list is a line or two
/// of the cache. A list that outgrows its block gets a new one at the end; when the array is full, it is written
/// anew without gaps.
///
/// In a short list an erased number leaves no gap. A list that once was longer than `long_length` is long for
/// ever, and keeps erased numbers until they are more than half of it: whoever erases must be able to tell.
///
/// Bytes: 24 a list, and 4 to 6 a number; 4 more while the array is written anew.
class Lists_in_blocks
{
public:
  using Index = std::uint32_t;

  struct List
  {
    std::size_t begin;              // position of the first
    Index length, number, capacity; // length: with erased ones
    Index owner;                    // for the user

    std::size_t end() const { return begin + length; }
    bool is_long() const { return capacity > long_length; }
  };

  static constexpr Index long_length = 32;

  void reserve(std::size_t number) { m_lists.reserve(number); }
  void add(Index owner) { m_lists.push_back({0, 0, 0, 0, owner}); }

  List& operator[](Index list) { return m_lists[list]; }
  const List& operator[](Index list) const { return m_lists[list]; }

  Index& at(std::size_t position) { return m_items[position]; }
  const Index& at(std::size_t position) const { return m_items[position]; }

  /// Gives each list the block of its capacity, and all of them some room to move to.
  /// \pre the lists are empty
  void lay_out()
  {
    std::size_t begin = 0;
    for (List& list : m_lists) {
      list.begin = begin;
      begin += list.capacity;
    }
    make_room(m_items, begin, 0);
  }

  /// \pre there is room for it
  void push_back(Index p, Index item)
  {
    List& list = m_lists[p];
    m_items[list.begin + list.length++] = item;
    ++list.number;
  }

  /// Appends `item_at(0)`, ...; `is_erased` tells whether an item of any list is.
  template <typename ItemAt, typename IsErased>
  void append(Index p, Index number, const ItemAt& item_at, const IsErased& is_erased)
  {
    if (m_lists[p].length + number > m_lists[p].capacity)
      move_to_larger_block(p, m_lists[p].length + number, is_erased);
    for (Index i = 0; i < number; ++i)
      push_back(p, item_at(i));
  }

  /// \pre the item is in the list; if it is long, it is one that `is_erased`
  template <typename IsErased>
  void erase(Index p, Index item, const IsErased& is_erased)
  {
    List& list = m_lists[p];
    --list.number;
    if (!list.is_long()) {
      // No jump depends on where the item is.
      std::size_t out = list.begin;
      for (std::size_t i = list.begin, end = list.end(); i < end; ++i) {
        const Index other = m_items[i];
        m_items[out] = other;
        out += other != item;
      }
    } else if (2 * list.number < list.length)
      std::remove_if(m_items.begin() + list.begin, m_items.begin() + list.end(), is_erased);
    else
      return;
    list.length = list.number;
  }

private:
  template <typename IsErased>
  void move_to_larger_block(Index p, Index needed, const IsErased& is_erased)
  {
    const Index capacity =
      needed > long_length ? needed + needed / 2 : (std::min)(long_length, needed + needed / 4);
    if (m_items.size() + capacity > m_highest_size)
      write_anew(capacity, is_erased);
    List& list = m_lists[p];
    const std::size_t begin = m_items.size();
    m_items.resize(begin + capacity);
    std::copy_n(m_items.begin() + list.begin, list.length, m_items.begin() + begin);
    list.begin = begin;
    list.capacity = capacity;
  }

  /// In the order of the lists, without gaps and erased items.
  template <typename IsErased>
  void write_anew(Index more, const IsErased& is_erased)
  {
    const auto capacity = [](const List& list) {
      return list.is_long() ? (std::max)(list.number, long_length + 1) : list.number;
    };
    std::size_t size = 0;
    for (const List& list : m_lists)
      size += capacity(list);
    Large_array<Index> items;
    make_room(items, size, more);
    std::size_t begin = 0;
    for (List& list : m_lists) {
      std::remove_copy_if(m_items.begin() + list.begin, m_items.begin() + list.end(), items.begin() + begin,
                          is_erased);
      list = {begin, list.number, list.number, capacity(list), list.owner};
      begin += list.capacity;
    }
    m_items = std::move(items);
  }

  /// For as many, `more`, and so many others that writing anew takes O(1) for each of them.
  void make_room(Large_array<Index>& items, std::size_t size, std::size_t more)
  {
    m_highest_size = size + size / 2 + m_lists.size() / 4 + more;
    items.reserve(m_highest_size);
    items.resize(size);
  }

  Large_array<List> m_lists;
  Large_array<Index> m_items;
  std::size_t m_highest_size = 0; // of m_items, before it is written anew
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_LISTS_IN_BLOCKS_H
