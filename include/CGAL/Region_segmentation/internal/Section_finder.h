// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SECTION_FINDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SECTION_FINDER_H

#include <CGAL/Region_segmentation/internal/Large_array.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Numbers the pairs of regions between which there are edges, by the first edge.
///
/// A pair hangs on the one of its regions that has fewer edges to others, in a chain with the newest first. A
/// chain is short: where two regions never share more than one section, as on a surface of a few handles cut
/// into connected regions, the lengths of the chains add up to a small multiple of the number of pairs, since
/// its graph has few edges for its vertices, as has each part of it. Whatever the regions are, a chain is at most the
/// square root of twice the number of edges long. A region's neighbors come soon after each other, so
/// chains are read from the cache, as a hash table would not be.
///
/// Bytes: 8 a region, 12 a section.
class Section_finder
{
public:
  using Index = std::uint32_t;

  explicit Section_finder(std::size_t number_of_regions)
    : m_edges_of(number_of_regions, 0), m_newest_of(number_of_regions, none)
  {}

  /// Must be called for all edges before the first section is looked for.
  void count(Index a, Index b)
  {
    ++m_edges_of[a];
    ++m_edges_of[b];
  }

  Index find_or_add(Index a, Index b)
  {
    const bool at_a = m_edges_of[a] < m_edges_of[b] || (m_edges_of[a] == m_edges_of[b] && a < b);
    Index& newest = m_newest_of[at_a ? a : b];
    for (Index s = newest; s != none; s = m_older[s])
      if (m_sections[s] == std::make_pair(a, b) || m_sections[s] == std::make_pair(b, a))
        return s;
    const Index s = Index(m_sections.size());
    m_sections.push_back({a, b});
    m_older.push_back(newest);
    newest = s;
    return s;
  }

  /// The two regions of each, as they came with the first edge.
  const Large_array<std::pair<Index, Index>>& sections() const { return m_sections; }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  Large_array<Index> m_edges_of, m_newest_of; // by region
  Large_array<std::pair<Index, Index>> m_sections;
  Large_array<Index> m_older;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SECTION_FINDER_H
