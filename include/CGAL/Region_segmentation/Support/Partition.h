// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPPORT_PARTITION_H
#define CGAL_REGION_SEGMENTATION_SUPPORT_PARTITION_H

#include <CGAL/Region_segmentation/Support/Large_array.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

namespace internal {

/// Numbers distinct keys 0, 1, ... in the order of their first occurrence.
///
/// Keys below a bound, as almost all labels are, are looked up in a growing array, all others in a
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
    constexpr Index none = (std::numeric_limits<Index>::max)();
    if (key < m_bound && key >= m_numbers.size())
      m_numbers.resize((std::min)(m_bound, 2 * std::size_t(key) + 64), none);
    Index& number = key < m_bound ? m_numbers[key]
                                  : m_large_numbers.emplace(key, none).first->second;
    if (number == none)
      number = m_size++;
    return number;
  }

  std::size_t size() const { return m_size; }

private:
  std::size_t m_bound;
  std::vector<Index> m_numbers;                             // of keys below the bound
  std::unordered_map<std::uint64_t, Index> m_large_numbers; // of all others
  Index m_size = 0;
};

/// Numbers the labels of elements in the order of their first occurrence. The label -1 of their
/// type, which stands for none, has the highest number of 32 bits; no label of `bool` stands for
/// none. `label_of` receives the labels by number.
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

/// \ingroup PkgRegionSegmentationData
/// A partition of the elements 0 .. `size()` - 1 into the parts 0 .. `number_of_parts()` - 1: of
/// faces into regions or segments, of regions into segments.
///
/// No part is empty, and parts are numbered by their first element; so two partitions are equal if
/// and only if their numbers are. Memory: 4 bytes per element.
class Partition
{
public:
  using Index = std::uint32_t;
  /// A vector of the numbers of parts, by element; `resize()` does not initialize them.
  using Numbers = Large_array<Index>;

  /// A partition without elements.
  Partition() = default;

  /// \pre `is_valid()`
  Partition(Numbers part_of, std::size_t number_of_parts)
    : m_part_of(std::move(part_of))
    , m_number_of_parts(number_of_parts)
  {
    CGAL_precondition(is_valid());
  }
  /// As above, the numbers copied from a range.
  template <typename IndexRange>
  Partition(const IndexRange& part_of, std::size_t number_of_parts)
    : Partition(Numbers(std::begin(part_of), std::end(part_of)), number_of_parts)
  {}

  /// The partition in which each element is a part.
  static Partition into_single_elements(std::size_t size)
  {
    Numbers part_of(size);
    std::iota(part_of.begin(), part_of.end(), Index(0));
    return Partition(std::move(part_of), size);
  }

  /// The partition in which elements with equal labels form a part.
  ///
  /// \tparam LabelRange a range of forward iterators with an integral value type of at most 64 bits
  /// \pre there are fewer than 2^32 - 1 labels
  ///
  /// Complexity: O(size) expected.
  template <typename LabelRange>
  static Partition from_labels(const LabelRange& labels)
  {
    using Label = std::decay_t<decltype(*std::begin(labels))>;
    return from_labels(labels, std::size_t(std::distance(std::begin(labels), std::end(labels))),
                       [](const Label& label) { return label; });
  }

  /// As above, for a range of elements with the labels `label_of(element)`.
  template <typename Range, typename LabelOf>
  static Partition from_labels(const Range& elements, std::size_t expected_size,
                               const LabelOf& label_of)
  {
    Partition result;
    result.m_part_of.reserve(expected_size);
    internal::Key_numbering number(2 * expected_size + 1024);
    for (const auto& element : elements) {
      const auto label = label_of(element);
      static_assert(std::is_integral<decltype(label)>::value &&
                      sizeof(label) <= sizeof(std::uint64_t),
                    "labels are integral, of at most 64 bits");
      // Different values of one type stay different, negative ones included.
      result.m_part_of.push_back(number(static_cast<std::uint64_t>(label)));
    }
    CGAL_precondition_msg(result.size() < (std::numeric_limits<Index>::max)(),
                          "a partition has fewer than 2^32 - 1 elements");
    result.m_number_of_parts = number.size();
    return result;
  }

  /// Whether the numbers are those of a partition: below `number_of_parts()`, each number used, and
  /// ordered by the first elements.
  bool is_valid() const
  {
    std::size_t used = 0;
    for (const Index part : m_part_of) {
      if (part > used)
        return false;
      used += part == used;
    }
    return used == m_number_of_parts;
  }

  std::size_t size() const { return m_part_of.size(); }
  std::size_t number_of_parts() const { return m_number_of_parts; }

  /// The part of an element.
  Index operator[](std::size_t element) const { return m_part_of[element]; }
  auto begin() const { return m_part_of.begin(); }
  auto end() const { return m_part_of.end(); }

  friend bool operator==(const Partition& a, const Partition& b)
  {
    return a.m_part_of == b.m_part_of;
  }
  friend bool operator!=(const Partition& a, const Partition& b) { return !(a == b); }

private:
  Numbers m_part_of;
  std::size_t m_number_of_parts = 0;
};

namespace internal {
/// \throws Invalid_method unless the regions are a partition of so many faces
inline void check_regions(const Partition& regions, std::size_t number_of_faces)
{
  if (regions.size() != number_of_faces || !regions.is_valid())
    throw Invalid_method("the regions are " + std::to_string(regions.number_of_parts()) + " of " +
                         std::to_string(regions.size()) + " faces" +
                         (regions.is_valid() ? "" : ", not numbered by their first faces") +
                         "; the mesh has " + std::to_string(number_of_faces) + " faces");
}
} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// The partition of the elements of `fine` that joins its parts as `coarse` does.
/// \pre the elements of `coarse` are the parts of `fine`
inline Partition composed(const Partition& fine, const Partition& coarse)
{
  CGAL_precondition(fine.number_of_parts() == coarse.size());
  Partition::Numbers part_of(fine.size());
  for (std::size_t i = 0; i < part_of.size(); ++i)
    part_of[i] = coarse[fine[i]];
  return Partition(std::move(part_of), coarse.number_of_parts());
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPPORT_PARTITION_H
