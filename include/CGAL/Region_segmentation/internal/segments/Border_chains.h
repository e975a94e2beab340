// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_BORDER_CHAINS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_BORDER_CHAINS_H

#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The edges between segments, joined to chains. An edge is represented by its halfedge in the segment of lower number
/// (`none` is above all), so chains between the same two segments run in one direction.
template <typename Traversal>
class Border_chains
{
public:
  using halfedge_descriptor = typename Traversal::halfedge_descriptor;

  explicit Border_chains(const Segmented_mesh<Traversal>& segmented)
    : m_segmented(segmented), m_at_vertex(segmented.traversal().number_of_vertices())
  {
    collect_edges();
    mark_borders_of_mesh();
  }

  /// Calls `f(halfedges, is_closed)`, with a temporary vector, for the open chains, then for the closed ones, each kind
  /// by the order of the edges.
  template <typename F>
  void for_each_chain(const F& f) const
  {
    std::vector<char> is_done(m_edges.size(), false);
    for (std::size_t e = 0; e < m_edges.size(); ++e)
      if (is_junction(source_of(e)))
        f(chain_from(e, is_done), false);
    for (std::size_t e = 0; e < m_edges.size(); ++e)
      if (!is_done[e])
        f(chain_from(e, is_done), true);
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// The edges between segments at a vertex.
  struct Vertex
  {
    std::size_t leaving = 0, arriving = 0; // numbers of edges
    std::size_t edge = none;               // one that leaves
    bool is_on_border_of_mesh = false;
  };

  std::size_t source_of(std::size_t e) const { return m_segmented.traversal().source_rank(m_edges[e]); }
  std::size_t target_of(std::size_t e) const
  {
    return m_segmented.traversal().source_rank(opposite(m_edges[e], m_segmented.mesh()));
  }

  void collect_edges()
  {
    const auto& mesh = m_segmented.mesh();
    m_segmented.for_each_border_halfedge([&](halfedge_descriptor h, auto segment) {
      if (CGAL::is_border(edge(h, mesh), mesh) || m_segmented.opposite_segment(h) < segment)
        return;
      m_edges.push_back(h);
      const std::size_t e = m_edges.size() - 1;
      Vertex& vertex = m_at_vertex[source_of(e)];
      ++vertex.leaving;
      vertex.edge = e;
      ++m_at_vertex[target_of(e)].arriving;
    });
  }

  void mark_borders_of_mesh()
  {
    const auto& mesh = m_segmented.mesh();
    for (auto e : edges(mesh))
      if (CGAL::is_border(e, mesh)) {
        const halfedge_descriptor h = halfedge(e, mesh);
        m_at_vertex[m_segmented.traversal().source_rank(h)].is_on_border_of_mesh = true;
        m_at_vertex[m_segmented.traversal().source_rank(opposite(h, mesh))].is_on_border_of_mesh = true;
      }
  }

  /// Inside the mesh, a vertex with two edges has two fans of faces: the edges separate the same two segments, and one of
  /// them leaves.
  bool is_junction(std::size_t vertex) const
  {
    const Vertex& v = m_at_vertex[vertex];
    return v.leaving != 1 || v.arriving != 1 || v.is_on_border_of_mesh;
  }

  std::vector<halfedge_descriptor> chain_from(std::size_t e, std::vector<char>& is_done) const
  {
    std::vector<halfedge_descriptor> chain;
    while (!is_done[e]) {
      is_done[e] = true;
      chain.push_back(m_edges[e]);
      const std::size_t vertex = target_of(e);
      if (is_junction(vertex))
        break;
      e = m_at_vertex[vertex].edge;
    }
    return chain;
  }

  const Segmented_mesh<Traversal>& m_segmented;
  std::vector<halfedge_descriptor> m_edges;
  std::vector<Vertex> m_at_vertex;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_BORDER_CHAINS_H
