// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_NUMBER_LABELS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_NUMBER_LABELS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Numbers distinct keys 0, 1, ... in the order of their first occurrence.
///
/// Keys below a bound, such as almost all labels, are looked up in a growing array, all others in a
/// hash table. (For 1 million faces in random order, the hash table takes 5 times as long as the
/// array with 10 labels, 80 times with 250,000.)
class Key_numbering
{
public:
  using Index = std::uint32_t;

  /// `bound`: the array never has more than this number of entries.
  explicit Key_numbering(std::size_t bound)
    : m_bound(bound)
  {}

  Index operator()(std::uint64_t key)
  {
    if (key == m_latest_key && m_size > 0) // consecutive faces often share a segment
      return m_latest;
    m_latest_key = key;
    m_latest = key < m_bound ? find_or_add_small(std::size_t(key)) : find_or_add_large(key);
    return m_latest;
  }

  std::size_t size() const { return m_size; }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  Index find_or_add_small(std::size_t key)
  {
    if (key >= m_numbers.size())
      m_numbers.resize((std::min)(m_bound, 2 * key + 64), Index(none));
    if (m_numbers[key] == none)
      m_numbers[key] = m_size++;
    return m_numbers[key];
  }

  Index find_or_add_large(std::uint64_t key)
  {
    const auto [place, is_new] = m_large_numbers.emplace(key, m_size);
    m_size += is_new;
    return place->second;
  }

  std::size_t m_bound;
  std::vector<Index> m_numbers;                             // of keys below the bound
  std::unordered_map<std::uint64_t, Index> m_large_numbers; // of all others
  std::uint64_t m_latest_key = 0;
  Index m_latest = 0;
  Index m_size = 0;
};

/// The numbers of the labels of elements, by their first elements; the highest number for the label
/// -1 of their type, which is none (there is none of `bool`). `label_of` receives the labels by
/// number.
template <typename Label, typename Value>
std::vector<std::uint32_t> number_labels(const std::vector<Label>& labels,
                                         std::vector<Value>& label_of)
{
  std::vector<std::uint32_t> result;
  result.reserve(labels.size());
  Key_numbering number(2 * labels.size() + 1024);
  for (const Label label : labels) {
    const bool is_none = !std::is_same<Label, bool>::value && label == Label(-1);
    result.push_back(is_none ? (std::numeric_limits<std::uint32_t>::max)()
                             : number(static_cast<std::uint64_t>(label)));
    if (label_of.size() < number.size())
      label_of.push_back(Value(label));
  }
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_NUMBER_LABELS_H
