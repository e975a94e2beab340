// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_READ_FACE_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_READ_FACE_GRAPH_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/surface/Mesh_order.h>
#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The points of the vertices. A vertex point map may return points by value.
template <typename FaceGraph, typename Pack>
void read_points(const Mesh_order<FaceGraph, Pack>& order, const Pack& np, Surface_arrays& arrays,
                 const Execution& execution)
{
  const auto point_map = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
    get_const_property_map(vertex_point, order.mesh()));
  arrays.points.resize(order.number_of_vertices());
  for_each_block(execution, order.number_of_vertices(),
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     const auto v = order.ordered_vertices()[i];
                     const auto& p = get(point_map, v);
                     Double_3& q = arrays.points[i];
                     q = {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
                   }
                 });
}

/// The corners of the faces, and the faces across their sides.
template <typename FaceGraph, typename Pack>
void read_corners(const Mesh_order<FaceGraph, Pack>& order, Raw_surface& raw,
                  const Execution& execution)
{
  const FaceGraph& mesh = order.mesh();
  Surface_arrays& arrays = arrays_of(raw.surface);
  arrays.first_corners.resize(order.number_of_faces() + 1);
  arrays.corners.resize(num_halfedges(mesh));
  raw.neighbors.resize(num_halfedges(mesh));
  const auto halfedges_of = [&](std::size_t face) {
    return CGAL::halfedges_around_face(halfedge(order.ordered_faces()[face], mesh), mesh);
  };
  const std::size_t number = for_each_block_of_output(
    execution, order.number_of_faces(),
    [&](std::size_t, std::size_t begin, std::size_t end) {
      std::size_t result = 0;
      for (std::size_t f = begin; f < end; ++f)
        result += halfedges_of(f).size();
      return result;
    },
    [&](std::size_t, std::size_t begin, std::size_t end, std::size_t corner) {
      for (std::size_t f = begin; f < end; ++f) {
        arrays.first_corners[f] = Surface::Index(corner);
        for (auto h : halfedges_of(f)) {
          arrays.corners[corner] = order.vertex_rank(source(h, mesh));
          raw.neighbors[corner++] = order.face_rank(opposite(h, mesh));
        }
      }
      return corner;
    });
  arrays.first_corners.back() = Surface::Index(number);
  arrays.corners.resize(number);
  raw.neighbors.resize(number);
  // Not face by face above: what is unpredictable waits for memory there.
  begin_at_lowest_vertices(raw, execution);
}

template <typename FaceGraph, typename Pack>
Raw_surface read_face_graph(const Mesh_order<FaceGraph, Pack>& order, const Pack& np,
                            const Execution& execution)
{
  Raw_surface raw;
  read_points(order, np, arrays_of(raw.surface), execution.step(0, 0.3));
  read_corners(order, raw, execution.step(0.3, 1));
  set_unit(raw.surface);
  return raw;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_READ_FACE_GRAPH_H
