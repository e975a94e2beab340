// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_FRONT_QUEUE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_FRONT_QUEUE_H

#include <CGAL/Region_segmentation/internal/support/Float_key.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A priority queue for searches by distance: the faces of a front, nearest first, then by lower index.
///
/// Only faces in the lowest slice of distances are in a heap, so it is small; the others are in an unsorted list per
/// slice, and beyond the last slice in a common list. Slices much narrower than the front are fastest, but the order
/// does not depend on them. Memory: 12 bytes per push, until the queue is empty.
///
/// With a `std::priority_queue` of keys superfacets take 1.15 to 1.25 times as long at 160,000 faces and at 1 million,
/// and the entire default method 1.08 to 1.13 times; at 10,000 faces 1.06 and 1.02 times.
class Front_queue
{
public:
  using Index = std::uint32_t;
  using Key = Float_key; ///< distance, rounded to float, and face

  /// `width`: of a slice; with 0 there is one slice
  explicit Front_queue(double width)
    : m_scale(width > 0 ? float(1 / width) : 0)
  {
    m_slices.fill(none);
  }

  bool empty() const { return m_heap.empty() && m_waiting.empty(); }

  void push(Key key)
  {
    const std::size_t slice = slice_of(key);
    if (slice <= m_slice) {
      m_heap.push_back(key);
      std::push_heap(m_heap.begin(), m_heap.end(), std::greater<>());
    } else
      wait(key, slice);
  }

  /// \pre the queue is not empty
  Key pop()
  {
    if (m_heap.empty())
      fill_heap();
    std::pop_heap(m_heap.begin(), m_heap.end(), std::greater<>());
    const Key key = m_heap.back();
    m_heap.pop_back();
    if (m_heap.empty() && m_number_waiting == 0) {
      m_waiting.clear();
      m_slice = m_first_slice = 0;
    }
    return key;
  }

private:
  static constexpr std::size_t number_of_slices = 1024;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  struct Waiting
  {
    Key key;
    Index next; // in its slice
  };

  std::size_t slice_of(Key key) const
  {
    return std::size_t((std::min)(1e9f, value_of(key) * m_scale)); // also for NaN (infinity * 0)
  }

  void wait(Key key, std::size_t slice)
  {
    Index& first = slice - m_first_slice < number_of_slices ? m_slices[slice - m_first_slice] : m_behind;
    m_waiting.push_back({key, first});
    first = Index(m_waiting.size() - 1);
    ++m_number_waiting;
  }

  /// Takes the next slice that is not empty.
  void fill_heap()
  {
    while (true) {
      while (++m_slice < m_first_slice + number_of_slices)
        if (m_slices[m_slice - m_first_slice] != none) {
          take(m_slices[m_slice - m_first_slice]);
          return;
        }
      move_slices();
    }
  }

  void take(Index& first)
  {
    for (; first != none; first = m_waiting[first].next) {
      m_heap.push_back(m_waiting[first].key);
      --m_number_waiting;
    }
    std::make_heap(m_heap.begin(), m_heap.end(), std::greater<>());
  }

  /// Moves the slices to the distances beyond them.
  void move_slices()
  {
    std::size_t lowest = (std::numeric_limits<std::size_t>::max)();
    for (Index i = m_behind; i != none; i = m_waiting[i].next)
      lowest = (std::min)(lowest, slice_of(m_waiting[i].key));
    m_first_slice = lowest;
    m_slice = lowest - 1;
    Index i = m_behind;
    m_behind = none;
    while (i != none) {
      const Waiting w = m_waiting[i];
      i = w.next;
      --m_number_waiting;
      wait(w.key, slice_of(w.key));
    }
  }

  float m_scale;
  std::array<Index, number_of_slices> m_slices; // the first entry of each
  Index m_behind = none;
  std::vector<Waiting> m_waiting;
  std::vector<Key> m_heap; // of slice `m_slice` and before it
  std::size_t m_number_waiting = 0, m_slice = 0, m_first_slice = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_FRONT_QUEUE_H
