// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_EDGES_OF_ADJACENCIES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_EDGES_OF_ADJACENCIES_H

#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/check_maps.h>
#include <CGAL/Region_segmentation/internal/surface/Mesh_order.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(halfedge, adjacency)` for the sides of a face that lead to lower ones, each with the
/// halfedge there: the adjacencies of a face to the same lower face follow its boundary from its
/// vertex of lowest number, edges first.
template <typename FaceGraph, typename Pack, typename F>
void for_each_side_to_lower_face(const Mesh_order<FaceGraph, Pack>& order, const Surface& surface,
                                 Surface::Index face, const F& f)
{
  using Order = Mesh_order<FaceGraph, Pack>;
  using halfedge_descriptor = typename Order::halfedge_descriptor;
  using Side = std::pair<Surface::Index, halfedge_descriptor>; // the face across, the halfedge
                                                               // there
  const FaceGraph& mesh = order.mesh();
  boost::container::small_vector<Side, 8> sides;
  const auto first = order.first_halfedge(order.ordered_faces()[face]);
  for (halfedge_descriptor h : CGAL::halfedges_around_face(first, mesh))
    if (const Surface::Index across = order.face_rank(opposite(h, mesh)); across < face)
      sides.push_back({across, opposite(h, mesh)});
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side& s, const Side& t) { return s.first < t.first; });
  std::size_t adjacency = sides.empty() ? 0 : surface.first_adjacency(face);
  for (const Side& side : sides) {
    while (surface.lower_face(adjacency) < side.first)
      ++adjacency;
    f(side.second, adjacency++);
  }
}

/// Calls `f(halfedge, adjacency)` for the edges of the face graph of which a surface was made that
/// have two different faces and `is_wanted()`, each with the halfedge of the lower face.
template <typename FaceGraph, typename Pack, typename IsWanted, typename F>
void for_each_edge_with_adjacency(const Mesh_order<FaceGraph, Pack>& order, const Surface& surface,
                                  const IsWanted& is_wanted, const F& f)
{
  const FaceGraph& mesh = order.mesh();
  std::vector<bool> has_wanted(order.number_of_faces());
  for (const auto e : edges(mesh))
    if (is_wanted(e))
      for (const auto h : {halfedge(e, mesh), opposite(halfedge(e, mesh), mesh)})
        if (const Surface::Index face = order.face_rank(h); face != order.none)
          has_wanted[face] = true;
  for (Surface::Index face = 0; face < order.number_of_faces(); ++face)
    if (has_wanted[face])
      for_each_side_to_lower_face(order, surface, face, [&](const auto& h, std::size_t adjacency) {
        if (is_wanted(edge(h, mesh)))
          f(h, adjacency);
      });
}

/// Constrains the adjacencies across the edges of a map.
template <typename FaceGraph, typename Pack, typename EdgeMap>
void add_constraints_of_edges(const Mesh_order<FaceGraph, Pack>& order, const Surface& surface,
                              const EdgeMap& map, Constraints& constraints)
{
  static_assert(check_edge_map<EdgeMap, FaceGraph>());
  for_each_edge_with_adjacency(
    order, surface, [&](const auto& e) { return bool(get(map, e)); },
    [&](const auto&, std::size_t adjacency) {
      constraints.add(adjacency, surface.number_of_adjacencies());
    });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_EDGES_OF_ADJACENCIES_H
