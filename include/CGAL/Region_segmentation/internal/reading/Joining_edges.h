// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_JOINING_EDGES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_JOINING_EDGES_H

#include <CGAL/Region_segmentation/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds the edge across which each degenerate face joins: the longest of those that are not constrained; of several, the
/// one to the lowest face, and of several to that face the first. O(n log n) for n edges.
class Joining_edges
{
  using Index = Flat_mesh::Index;

public:
  /// An edge of a degenerate face to another one. Edges of a face have numbers in the order of the dual edges.
  void add(Index face, Index other, double length, Index edge) { m_candidates.push_back({length, face, other, edge}); }

  /// Calls `f(edge)` for the edge of each face. Reorders the edges.
  template <typename F>
  void for_each(const F& f)
  {
    std::sort(m_candidates.begin(), m_candidates.end(), [](const Candidate& a, const Candidate& b) {
      if (a.face != b.face)
        return a.face < b.face;
      if (a.length != b.length)
        return a.length > b.length;
      return a.other != b.other ? a.other < b.other : a.edge < b.edge;
    });
    for (std::size_t i = 0; i < m_candidates.size(); ++i)
      if (i == 0 || m_candidates[i].face != m_candidates[i - 1].face)
        f(m_candidates[i].edge);
  }

private:
  struct Candidate
  {
    double length;
    Index face, other, edge;
  };

  std::vector<Candidate> m_candidates;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_JOINING_EDGES_H
