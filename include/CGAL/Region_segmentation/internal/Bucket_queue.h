// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_BUCKET_QUEUE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_BUCKET_QUEUE_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A priority queue of numbers with a value; the lowest value goes first, the lower number of equal ones.
///
/// Entries lie in buckets by the leading bits of their values; only the bucket that is next is sorted, after it
/// was split into smaller ones until few are left in each. So an entry is moved a few times, in the order of
/// memory, where a heap of millions compares it twenty times, each time with a jump that cannot be predicted;
/// and what comes next is known in batches, so that what is needed of it can be fetched together. Meant for
/// values that rise: one below the end of the batch goes to a heap of its own.
///
/// Complexity: O(1) an entry in practice, O(log n) and 64 moves at worst.
///
/// Bytes: 16 an entry, and what a vector has in reserve.
class Bucket_queue
{
public:
  using Id = std::uint32_t;
  using Entry = std::pair<double, Id>;

  /// \pre no value is NaN, here and later
  void assign(std::vector<Entry> entries)
  {
    m_levels.clear(); // entries that an earlier use left behind would have no place in the new buckets
    m_depth = 0;
    m_batch.clear();
    m_early = Heap();
    m_batch_end = 0;
    if (entries.empty())
      return;
    const double lowest = std::min_element(entries.begin(), entries.end())->first;
    m_batch_end = bits(lowest);
    split(std::move(entries), m_batch_end, bits(std::numeric_limits<double>::infinity()));
  }

  void push(Entry entry)
  {
    const std::uint64_t value = bits(entry.first);
    std::size_t depth = value < m_batch_end ? 0 : m_depth;
    while (depth > 0 && m_levels[depth - 1].last < value)
      --depth;
    if (depth == 0)
      m_early.push(entry);
    else
      m_levels[depth - 1].bucket_of(value).push_back(entry);
  }

  bool has_top() const { return !m_batch.empty() || !m_early.empty(); }
  /// \pre `has_top()`
  const Entry& top() const { return is_early_next() ? m_early.top() : m_batch.back(); }
  void pop()
  {
    if (is_early_next())
      m_early.pop();
    else
      m_batch.pop_back();
  }

  /// Goes on to the next entries; `prepare(entries)` may leave out some. Returns whether there are any more.
  /// \pre not `has_top()`
  template <typename Prepare>
  bool next_batch(const Prepare& prepare)
  {
    while (m_batch.empty() && m_depth > 0) {
      Level& level = m_levels[m_depth - 1];
      while (level.next < level.number && level.buckets[level.next].empty())
        ++level.next;
      if (level.next == level.number) {
        m_batch_end = level.last + 1;
        --m_depth;
        continue;
      }
      const std::uint64_t first = level.first + (std::uint64_t(level.next) << level.shift);
      const std::uint64_t last = first + (std::min)(level.last - first, (std::uint64_t(1) << level.shift) - 1);
      std::vector<Entry>& bucket = level.buckets[level.next++];
      if (bucket.size() > batch_size && level.shift > 0) {
        m_batch_end = first;
        split(std::exchange(bucket, {}), first, last);
        continue;
      }
      m_batch_end = last + 1;
      m_batch.swap(bucket);
      prepare(m_batch);
      std::sort(m_batch.begin(), m_batch.end(), std::greater<Entry>());
    }
    return !m_batch.empty();
  }

private:
  using Heap = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  static constexpr std::size_t batch_size = 32, highest_number_of_buckets = 4096;

  // Covers the values first .. last; the buckets before `next` are done.
  struct Level
  {
    std::uint64_t first, last;
    int shift;
    std::size_t next, number;
    std::vector<std::vector<Entry>> buckets;

    std::vector<Entry>& bucket_of(std::uint64_t value) { return buckets[(value - first) >> shift]; }
  };

  /// In the order of the values.
  static std::uint64_t bits(double value)
  {
    value += 0.0; // -0 is 0
    std::uint64_t result;
    std::memcpy(&result, &value, sizeof result);
    const std::uint64_t sign = std::uint64_t(1) << 63;
    return result & sign ? ~result : result | sign;
  }

  bool is_early_next() const
  {
    return !m_early.empty() && (m_batch.empty() || m_early.top() < m_batch.back());
  }

  void split(std::vector<Entry> entries, std::uint64_t first, std::uint64_t last)
  {
    if (m_levels.size() == m_depth)
      m_levels.emplace_back();
    Level& level = m_levels[m_depth++];
    const std::size_t number =
      (std::min)((std::max)(2 * entries.size() / batch_size, std::size_t(2)), highest_number_of_buckets);
    level.first = first;
    level.last = last;
    level.next = 0;
    level.shift = 0;
    while ((last - first) >> level.shift >= number)
      ++level.shift;
    level.number = std::size_t((last - first) >> level.shift) + 1;
    if (level.buckets.size() < level.number)
      level.buckets.resize(level.number);
    for (const Entry& entry : entries)
      level.bucket_of(bits(entry.first)).push_back(entry);
  }

  std::vector<Level> m_levels; // the first m_depth of them, each within a bucket of the one before
  std::size_t m_depth = 0;
  std::vector<Entry> m_batch; // the next one last
  std::uint64_t m_batch_end = 0;
  Heap m_early; // below m_batch_end, come when the batch was made
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_BUCKET_QUEUE_H
