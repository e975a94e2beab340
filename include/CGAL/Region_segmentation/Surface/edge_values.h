// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_EDGE_VALUES_H
#define CGAL_REGION_SEGMENTATION_SURFACE_EDGE_VALUES_H

#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(edge, adjacency)` for the sides of the faces of a mesh, in order: twice for an edge
/// between two faces, once for a border edge. The adjacency is that in the surface of the mesh;
/// `Surface::none` for an edge on the border of the surface, and for one with the same face on both
/// sides.
template <typename FaceGraph, typename F>
void for_each_side_of_mesh(const FaceGraph& mesh, const Surface& surface, const F& f)
{
  std::size_t face_index = 0;
  for (const auto face : faces(mesh)) {
    std::size_t i = 0;
    for (const auto h : CGAL::halfedges_around_face(halfedge(face, mesh), mesh)) {
      f(edge(h, mesh), surface.adjacency_in_mesh(face_index, i));
      ++i;
    }
    ++face_index;
  }
}

} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// reads a property map of the edges of a mesh: returns for each adjacency of its surface 1, if the
/// map is `true` for one of its edges (coinciding border edges have one adjacency), else 0.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam EdgeMap a model of `ReadablePropertyMap` with the edge descriptor as key and a value
///         type convertible to `bool`
/// \param mesh, surface the mesh, and its surface
/// \param map is read
/// \pre `surface` was made by `make_surface(mesh)`
///
/// Complexity: O(F).
template <typename FaceGraph, typename EdgeMap>
std::vector<std::uint8_t> edge_values(const FaceGraph& mesh, const Surface& surface,
                                      const EdgeMap& map)
{
  static_assert(internal::check_edge_map<EdgeMap, FaceGraph>());
  std::vector<std::uint8_t> marks(surface.number_of_adjacencies());
  internal::for_each_side_of_mesh(mesh, surface, [&](const auto& e, Surface::Index a) {
    if (a != Surface::none)
      marks[a] |= bool(get(map, e));
  });
  return marks;
}

/// \ingroup PkgRegionSegmentationData
/// writes marks of the adjacencies of a surface to a property map of the edges of its mesh: `true`
/// for edges whose adjacency is marked or constrained, and for borders of the surface, else
/// `false`.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam EdgeMap a model of `WritablePropertyMap` with the edge descriptor as key and a value
///         type constructible from `bool`
/// \param mesh, surface the mesh, and its surface
/// \param marks by adjacency: 1 or 0, as `edge_values()` and `detect_feature_edges()` return
/// \param map every key is written
/// \returns the number of edges with `true`
/// \pre `surface` was made by `make_surface(mesh)`
///
/// Complexity: O(F).
template <typename FaceGraph, typename EdgeMap>
std::size_t write_edge_values(const FaceGraph& mesh, const Surface& surface,
                              const std::vector<std::uint8_t>& marks, EdgeMap map)
{
  static_assert(internal::check_edge_map<EdgeMap, FaceGraph>());
  using Value = typename boost::property_traits<EdgeMap>::value_type;
  std::size_t number_of_sides = 0;
  internal::for_each_side_of_mesh(mesh, surface, [&](const auto& e, Surface::Index a) {
    const bool is_true = a == Surface::none ? CGAL::is_border(e, mesh)
                                            : marks[a] || surface.has_flag(a, Surface::CONSTRAINED);
    put(map, e, Value(is_true));
    if (is_true) // the edge is visited from each of its faces
      number_of_sides += CGAL::is_border(e, mesh) ? 2u : 1u;
  });
  return number_of_sides / 2;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_EDGE_VALUES_H
