// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_READ_FACE_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_READ_FACE_GRAPH_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/surface/Mesh_order.h>
#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The points of the vertices. A vertex point map may return points by value.
template <typename FaceGraph, typename Pack>
void read_points(const Mesh_order<FaceGraph, Pack>& order, const Pack& np, Surface_arrays& arrays,
                 std::vector<bool>& is_used, const Execution& execution)
{
  const auto point_map = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
    get_const_property_map(vertex_point, order.mesh()));
  const auto no_halfedge = boost::graph_traits<FaceGraph>::null_halfedge();
  arrays.points.resize(order.number_of_vertices());
  std::vector<std::size_t> isolated(number_of_blocks(order.number_of_vertices()));
  for_each_block(execution, order.number_of_vertices(),
                 [&](std::size_t block, std::size_t rank, std::size_t) {
                   for (auto v : order.vertices_of_block(block)) {
                     const auto& p = get(point_map, v);
                     arrays.points[rank++] = {CGAL::to_double(p[0]), CGAL::to_double(p[1]),
                                              CGAL::to_double(p[2])};
                     isolated[block] += halfedge(v, order.mesh()) == no_halfedge;
                   }
                 });
  if (std::count(isolated.begin(), isolated.end(), std::size_t(0)) ==
      std::ptrdiff_t(isolated.size()))
    return; // all are used
  for (auto v : vertices(order.mesh()))
    is_used.push_back(halfedge(v, order.mesh()) != no_halfedge);
}

/// The corners of the faces, from that of lowest number on, and the faces across their sides.
template <typename FaceGraph, typename Pack>
void read_corners(const Mesh_order<FaceGraph, Pack>& order, Raw_surface& raw,
                  const Execution& execution)
{
  using Index = Surface::Index;
  const FaceGraph& mesh = order.mesh();
  Surface_arrays& arrays = arrays_of(raw.surface);
  const std::vector<std::size_t> offsets = block_offsets(
    execution.step(0, 0.2), order.number_of_faces(),
    [&](std::size_t block, std::size_t, std::size_t) {
      std::size_t number = 0;
      for (auto f : order.faces_of_block(block)) {
        const auto start = halfedge(f, mesh);
        auto h = start;
        do {
          ++number;
          h = next(h, mesh);
        } while (h != start);
      }
      return number;
    });
  arrays.corners.resize(offsets.back());
  raw.neighbors.resize(offsets.back());
  arrays.first_corners.resize(order.number_of_faces() + 1);
  arrays.first_corners.back() = Index(offsets.back());
  Index *const corners = arrays.corners.data(), *const neighbors = raw.neighbors.data();
  Index* const first_corners = arrays.first_corners.data();
  for_each_block(execution.step(0.2, 1), order.number_of_faces(),
                 [&](std::size_t block, std::size_t rank, std::size_t) {
                   const auto rank_of_face = order.rank_of_face();
                   const auto rank_of_vertex = order.rank_of_vertex();
                   std::size_t corner = offsets[block];
                   for (auto f : order.faces_of_block(block)) {
                     const std::size_t first = corner;
                     std::size_t lowest = corner;
                     first_corners[rank++] = Index(first);
                     const auto start = halfedge(f, mesh);
                     auto h = start;
                     do {
                       const auto g = opposite(h, mesh);
                       const auto across = face(g, mesh);
                       corners[corner] = Index(rank_of_vertex(target(g, mesh)));
                       neighbors[corner] = across == boost::graph_traits<FaceGraph>::null_face()
                                             ? Raw_surface::none
                                             : Index(rank_of_face(across));
                       lowest = corners[corner] < corners[lowest] ? corner : lowest;
                       ++corner;
                       h = next(h, mesh);
                     } while (h != start);
                     if (lowest != first) {
                       std::rotate(corners + first, corners + lowest, corners + corner);
                       std::rotate(neighbors + first, neighbors + lowest, neighbors + corner);
                     }
                   }
                 });
}

template <typename FaceGraph, typename Pack>
Raw_surface read_face_graph(const Mesh_order<FaceGraph, Pack>& order, const Pack& np,
                            const Execution& execution)
{
  Raw_surface raw;
  Surface_arrays& arrays = arrays_of(raw.surface);
  std::vector<bool> is_used; // by vertex; empty: all
  read_points(order, np, arrays, is_used, execution.step(0, 0.2));
  set_unit(raw.surface, is_used, execution.step(0.2, 0.3));
  read_corners(order, raw, execution.step(0.3, 1));
  return raw;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_READ_FACE_GRAPH_H
