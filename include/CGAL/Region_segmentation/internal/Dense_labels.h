// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_DENSE_LABELS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_DENSE_LABELS_H

#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Numbers distinct keys 0, 1, ... in the order in which they first come.
///
/// Keys below a bound, as almost all labels are, are looked up in an array that grows with them;
/// all others in a hash table with linear probing, at most three quarters full. Both hold numbers
/// alone, of 4 bytes.
class Key_numbering
{
public:
  using Index = std::uint32_t;

  /// `bound`: the array never has more than this number of entries.
  explicit Key_numbering(std::size_t bound) : m_bound(bound) {}

  Index operator()(std::uint64_t key)
  {
    if (key == m_latest_key && m_size > 0) // faces that follow each other often share a segment
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
    if (4 * m_large_keys.size() >= 3 * m_cells.size())
      grow();
    Index& cell = m_cells[position(key)];
    if (cell == none) {
      cell = Index(m_large_keys.size());
      m_large_keys.push_back({key, m_size++});
    }
    return m_large_keys[cell].number;
  }

  /// Where the key is, or the free cell where it would be.
  std::size_t position(std::uint64_t key) const
  {
    const std::size_t mask = m_cells.size() - 1;
    std::size_t i = hash(key) & mask;
    while (m_cells[i] != none && m_large_keys[m_cells[i]].key != key)
      i = (i + 1) & mask;
    return i;
  }

  /// The finalizer of MurmurHash3 (public domain).
  static std::size_t hash(std::uint64_t x)
  {
    x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdULL;
    x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return std::size_t(x ^ (x >> 33));
  }

  void grow()
  {
    m_cells.assign(m_cells.empty() ? 64 : 2 * m_cells.size(), Index(none));
    for (std::size_t i = 0; i < m_large_keys.size(); ++i)
      m_cells[position(m_large_keys[i].key)] = Index(i);
  }

  struct Large_key
  {
    std::uint64_t key;
    Index number;
  };

  std::size_t m_bound;
  std::vector<Index> m_numbers; // of keys below the bound
  std::vector<Large_key> m_large_keys;
  std::vector<Index> m_cells; // positions in m_large_keys; a power of two of them
  std::uint64_t m_latest_key = 0;
  Index m_latest = 0;
  Index m_size = 0;
};

/// The segment of every face: ids 0 .. number_of_labels - 1, numbered by their first face. Two
/// labelings with the same segments have the same dense labels.
struct Dense_labels
{
  using Index = Key_numbering::Index;

  std::vector<Index> of_face;
  std::size_t number_of_labels = 0;
};

/// Makes dense labels of the values `label(element)` over a range. O(size) expected.
template <typename Range, typename Label>
Dense_labels dense_labels(const Range& range, std::size_t expected_size, Label label)
{
  Dense_labels result;
  result.of_face.reserve(expected_size);
  Key_numbering number(2 * expected_size + 1024);
  for (const auto& element : range) {
    const auto value = label(element);
    static_assert(std::is_integral<decltype(value)>::value &&
                      sizeof(value) <= sizeof(std::uint64_t),
                  "labels are integral, of at most 64 bits");
    // Different values of one type stay different, negative ones included.
    result.of_face.push_back(number(static_cast<std::uint64_t>(value)));
  }
  CGAL_precondition_msg(result.of_face.size() < (std::numeric_limits<Dense_labels::Index>::max)(),
                        "there are fewer than 2^32 - 1 faces");
  result.number_of_labels = number.size();
  return result;
}

/// The labels that a property map gives to the faces of a mesh, in iteration order.
template <typename FaceGraph, typename FaceLabelMap>
Dense_labels read_face_labels(const FaceGraph& mesh, const FaceLabelMap& label_map)
{
  using Label = typename boost::property_traits<FaceLabelMap>::value_type;
  return dense_labels(faces(mesh), num_faces(mesh),
                      [&](const auto& f) -> Label { return get(label_map, f); });
}

/// The labels that a range holds.
template <typename LabelRange>
Dense_labels read_label_range(const LabelRange& labels)
{
  using Iterator = decltype(std::begin(labels));
  using Label = typename std::iterator_traits<Iterator>::value_type;
  return dense_labels(labels, std::size_t(std::distance(std::begin(labels), std::end(labels))),
                      [](const auto& label) -> Label { return label; });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_DENSE_LABELS_H
