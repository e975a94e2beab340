// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_BATCH_QUEUE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_BATCH_QUEUE_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A priority queue of numbers with a value, lowest value first, then lowest number. The next
/// entries are available in batches, so that their data can be prefetched together.
///
///     lowest                                          highest
///     | m_batch | m_run, and among it m_risen | m_later ... |
///
/// The lowest quarter of the entries is sorted when the previous one is used up. Intended for
/// increasing values: a pushed entry rarely belongs to the batch or to the sorted entries.
///
/// With a `std::priority_queue` and without prefetching, merging takes 1.25 to 1.6 times as long on
/// a noisy mesh of 160,000 faces and a smooth one of 1 million, and 1.7 to 2.5 times on a noisy one
/// of 1 million (`two-step` 1.05 to 1.7 times as long in all); on meshes of 3,000 to 30,000 faces
/// as long. With a `std::priority_queue` emptied in batches, and neighbors read in one loop, 1.3
/// to 1.7 times.
///
/// Complexity: O(log n) per entry. Bytes: 16 per entry, and the unused capacity of the vectors.
class Batch_queue
{
public:
  using Id = std::uint32_t;
  using Entry = std::pair<double, Id>;

  /// \pre no value is NaN, here and later
  void assign(std::vector<Entry> entries)
  {
    m_batch.clear();
    m_run.clear();
    m_risen = Heap();
    m_later = std::move(entries);
    m_batch_end = m_run_end = {-std::numeric_limits<double>::infinity(), 0};
  }

  void push(Entry entry)
  {
    if (entry < m_batch_end)
      m_batch.insert(std::upper_bound(m_batch.begin(), m_batch.end(), entry, std::greater<Entry>()),
                     entry);
    else if (entry < m_run_end)
      m_risen.push(entry);
    else
      m_later.push_back(entry);
  }

  bool has_top() const { return !m_batch.empty(); }
  /// \pre `has_top()`
  const Entry& top() const { return m_batch.back(); }
  void pop() { m_batch.pop_back(); }

  /// Advances to the next entries; `prepare(entries)` may drop entries. Returns whether any remain.
  /// \pre not `has_top()`
  template <typename Prepare>
  bool next_batch(const Prepare& prepare)
  {
    while (m_batch.empty()) {
      if (m_run.empty() && m_risen.empty())
        sort_run();
      while (m_batch.size() < batch_size && !(m_run.empty() && m_risen.empty()))
        m_batch.push_back(take_lowest());
      if (m_batch.empty())
        return false;
      m_batch_end = m_batch.back();
      prepare(m_batch);
      std::reverse(m_batch.begin(), m_batch.end());
    }
    return true;
  }

private:
  using Heap = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  static constexpr std::size_t batch_size = 32, smallest_run = 256;

  void sort_run()
  {
    if (m_later.empty())
      return;
    const std::size_t size = (std::min)(m_later.size(),
                                        (std::max)(m_later.size() / 4, smallest_run));
    const auto first = m_later.end() - std::ptrdiff_t(size);
    std::nth_element(m_later.begin(), first, m_later.end(), std::greater<Entry>());
    m_run.assign(first, m_later.end());
    m_later.erase(first, m_later.end());
    std::sort(m_run.begin(), m_run.end(), std::greater<Entry>());
    m_run_end = m_run.front();
  }

  /// \pre there is an entry in the run or among the risen ones
  Entry take_lowest()
  {
    Entry lowest;
    if (m_risen.empty() || (!m_run.empty() && m_run.back() < m_risen.top())) {
      lowest = m_run.back();
      m_run.pop_back();
    } else {
      lowest = m_risen.top();
      m_risen.pop();
    }
    return lowest;
  }

  std::vector<Entry> m_batch, m_run; // the next one last
  Heap m_risen;                      // pushed after the run was sorted, below its end
  std::vector<Entry> m_later;        // in no order
  Entry m_batch_end, m_run_end;      // the last one of each
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_BATCH_QUEUE_H
