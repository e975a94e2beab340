// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_BORDER_CHAINS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_BORDER_CHAINS_H

#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The edges between segments, joined to chains. An edge is represented by its halfedge in the
/// segment of lower number (`none` is above all), so that the chains between two segments run in
/// one direction.
class Border_chains
{
  using Index = Halfedge_table::Index;
  static constexpr Index none = Halfedge_table::none;

public:
  explicit Border_chains(const Segmented_halfedges& mesh)
    : m_mesh(mesh)
    , m_leaving(mesh.number_of_vertices, Index(none))
    , m_is_junction(mesh.number_of_vertices, false)
  {
    std::vector<Index> arriving(mesh.number_of_vertices, Index(none));
    const auto add = [&](Index& place, Index h, Index vertex) {
      m_is_junction[vertex] |= place != none; // a second one
      place = h;
    };
    for (Index h = 0; h < mesh.size(); ++h)
      if (mesh.opposite[h] == none)
        m_is_junction[mesh.source[h]] = m_is_junction[mesh.target(h)] = true;
      else if (mesh.segment(h) < mesh.segment_across(h)) {
        m_halfedges.push_back(h);
        add(m_leaving[mesh.source[h]], h, mesh.source[h]);
        add(arriving[mesh.target(h)], h, mesh.target(h));
      }
    // At any other vertex two edges separate the same two segments: one arrives, one leaves.
    for (std::size_t v = 0; v < mesh.number_of_vertices; ++v)
      m_is_junction[v] |= (m_leaving[v] == none) != (arriving[v] == none);
  }

  /// Calls `f(halfedges, is_closed)` for the open chains, then for the closed ones, each kind by
  /// its first faces.
  template <typename F>
  void for_each_chain(const F& f) const
  {
    std::vector<char> is_done(m_mesh.size(), false);
    for (Index h : m_halfedges)
      if (m_is_junction[m_mesh.source[h]])
        f(chain_from(h, is_done), false);
    for (Index h : m_halfedges)
      if (!is_done[h])
        f(chain_from(h, is_done), true);
  }

private:
  std::vector<Index> chain_from(Index h, std::vector<char>& is_done) const
  {
    std::vector<Index> chain;
    while (!is_done[h]) {
      is_done[h] = true;
      chain.push_back(h);
      if (m_is_junction[m_mesh.target(h)])
        break;
      h = m_leaving[m_mesh.target(h)];
    }
    return chain;
  }

  const Segmented_halfedges& m_mesh;
  std::vector<Index> m_halfedges;
  std::vector<Index> m_leaving;    // by vertex: a halfedge that leaves it
  std::vector<char> m_is_junction; // by vertex
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_BORDER_CHAINS_H
