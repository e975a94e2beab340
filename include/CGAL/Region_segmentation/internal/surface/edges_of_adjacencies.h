// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_EDGES_OF_ADJACENCIES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_EDGES_OF_ADJACENCIES_H

#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/check_maps.h>
#include <CGAL/Region_segmentation/internal/surface/Mesh_order.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Which adjacency of a surface each edge of the face graph is that it was made of: the adjacencies
/// of a face to the same lower face follow its boundary from its vertex of lowest number, edges
/// first.
template <typename FaceGraph, typename Pack>
class Edges_of_adjacencies
{
  using Index = Surface::Index;
  using Order = Mesh_order<FaceGraph, Pack>;
  using halfedge_descriptor = typename Order::halfedge_descriptor;

public:
  Edges_of_adjacencies(const Order& order, const Surface& surface)
    : m_order(order)
    , m_surface(surface)
  {}

  /// Calls `f(halfedge, adjacency)` for the edges that have two different faces and `is_wanted()`,
  /// each with the halfedge of the lower face.
  template <typename IsWanted, typename F>
  void for_each(const IsWanted& is_wanted, const F& f)
  {
    const FaceGraph& mesh = m_order.mesh();
    std::vector<bool> has_wanted(m_order.number_of_faces());
    for (const auto e : edges(mesh))
      if (is_wanted(e))
        for (const halfedge_descriptor h : {halfedge(e, mesh), opposite(halfedge(e, mesh), mesh)})
          if (const Index rank = m_order.face_rank(h); rank != Order::none)
            has_wanted[rank] = true;
    for (Index rank = 0; rank < m_order.number_of_faces(); ++rank)
      if (has_wanted[rank])
        for_each_of_face(rank, [&](halfedge_descriptor h, std::size_t adjacency) {
          if (is_wanted(edge(h, mesh)))
            f(h, adjacency);
        });
  }

private:
  template <typename F>
  void for_each_of_face(Index rank, const F& f)
  {
    const FaceGraph& mesh = m_order.mesh();
    const auto rank_of_vertex = m_order.rank_of_vertex();
    m_sides.clear();
    std::size_t lowest = Order::none, first = 0;
    const halfedge_descriptor start = halfedge(m_order.ordered_faces()[rank], mesh);
    for (halfedge_descriptor h : CGAL::halfedges_around_face(start, mesh)) {
      const std::size_t vertex = rank_of_vertex(source(h, mesh));
      if (vertex < lowest) {
        lowest = vertex;
        first = m_sides.size();
      }
      m_sides.push_back({m_order.face_rank(opposite(h, mesh)), opposite(h, mesh)});
    }
    std::rotate(m_sides.begin(), m_sides.begin() + std::ptrdiff_t(first), m_sides.end());
    m_sides.erase(std::remove_if(m_sides.begin(), m_sides.end(),
                                 [=](const Side& s) { return s.first >= rank; }),
                  m_sides.end());
    std::stable_sort(m_sides.begin(), m_sides.end(),
                     [](const Side& a, const Side& b) { return a.first < b.first; });
    std::size_t adjacency = m_sides.empty() ? 0 : m_surface.first_adjacency(rank);
    for (const Side& side : m_sides) {
      while (m_surface.lower_face(adjacency) < side.first)
        ++adjacency;
      f(side.second, adjacency++);
    }
  }

  using Side = std::pair<Index, halfedge_descriptor>; // the face across, the halfedge there

  const Order& m_order;
  const Surface& m_surface;
  std::vector<Side> m_sides;
};

/// Constrains the adjacencies across the edges of a map.
template <typename FaceGraph, typename Pack, typename EdgeMap>
void add_constraints_of_edges(const Mesh_order<FaceGraph, Pack>& order, const Surface& surface,
                              const EdgeMap& map, Constraints& constraints)
{
  static_assert(check_edge_map<EdgeMap, FaceGraph>());
  Edges_of_adjacencies<FaceGraph, Pack>(order, surface)
    .for_each([&](const auto& e) { return bool(get(map, e)); },
              [&](auto, std::size_t adjacency) {
                constraints.add(adjacency, surface.number_of_adjacencies());
              });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_EDGES_OF_ADJACENCIES_H
