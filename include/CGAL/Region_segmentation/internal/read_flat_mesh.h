// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READ_FLAT_MESH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READ_FLAT_MESH_H

#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/Flat_mesh_builder.h>
#include <CGAL/Region_segmentation/internal/Mesh_walk.h>
#include <CGAL/Region_segmentation/internal/Face_block.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Reads a face graph, once, into a `Flat_mesh`.
///
/// The dual edges of a face, those to lower faces, need the normals of these. So in sequence the blocks of faces are
/// read from the first one on, each with its edges; in parallel all faces are read and their edges counted, then all
/// edges are read.
template <typename ConcurrencyTag, typename FaceGraph, typename Pack>
class Flat_mesh_reader
{
  using Walk = Mesh_walk<FaceGraph, Pack>;
  using Boundary = typename Walk::Boundary;
  using Point_map = typename GetVertexPointMap<FaceGraph, Pack>::const_type;
  using halfedge_descriptor = typename Walk::halfedge_descriptor;
  using No_constraints =
    Static_boolean_property_map<typename boost::graph_traits<FaceGraph>::edge_descriptor, false>;
  using Constraint_map =
    typename CGAL::internal_np::Lookup_named_param_def<CGAL::internal_np::edge_is_constrained_t, Pack,
                                                       No_constraints>::type;
  static constexpr bool has_constraints = !std::is_same<Constraint_map, No_constraints>::value;

public:
  Flat_mesh_reader(const Walk& walk, const Pack& np, Flat_mesh::Content content)
    : m_walk(walk)
    , m_point_map(CGAL::parameters::choose_parameter(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
        get_const_property_map(vertex_point, walk.mesh())))
    , m_is_constrained(CGAL::parameters::choose_parameter(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained), No_constraints()))
    , m_with_points(content == Flat_mesh::Content::ANGLES_AND_POINTS)
    , m_builder(walk.number_of_faces(), num_halfedges(walk.mesh()) / 2)
  {}

  /// \throws Invalid_input if a point is not finite
  Flat_mesh read()
  {
    read_points();
    if constexpr (is_parallel<ConcurrencyTag>)
      return m_builder.finish(read_in_two_passes());
    else
      return m_builder.finish(read_in_one_pass());
  }

private:
  /// Of what belongs to the faces of a block, in the arrays.
  struct Place
  {
    std::size_t edge, corner;
  };

  /// Returns the number of dual edges.
  std::size_t read_in_one_pass()
  {
    Place place = {0, 0};
    Face_block block;
    for (std::size_t i = 0; i < number_of_blocks(m_walk.number_of_faces()); ++i) {
      read_block(i, block);
      set_faces(block);
      place.edge += set_edges_and_corners(i, place, block);
      place.corner += block.number_of_corners();
    }
    return place.edge;
  }

  /// Returns the number of dual edges.
  std::size_t read_in_two_passes()
  {
    const std::size_t size = m_walk.number_of_faces();
    std::vector<Place> places(number_of_blocks(size));
    for_each_block<ConcurrencyTag>(size, [&](std::size_t i, std::size_t, std::size_t) {
      Face_block block;
      read_block(i, block);
      set_faces(block);
      places[i] = {block.count_edges(), block.number_of_corners()};
    });
    Place end = {0, 0};
    for (Place& place : places)
      end = {end.edge + place.edge, end.corner + std::exchange(place, end).corner};
    for_each_block<ConcurrencyTag>(size, [&](std::size_t i, std::size_t, std::size_t) {
      Face_block block;
      read_block(i, block);
      set_edges_and_corners(i, places[i], block);
    });
    return end.edge;
  }

  template <typename Vertex>
  static Vector_3 point(const Point_map& map, const Vertex& v)
  {
    const auto& p = get(map, v);
    return {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
  }

  void read_points()
  {
    const std::size_t size = m_walk.number_of_vertices();
    if (m_with_points)
      m_builder.resize_points(size, num_halfedges(m_walk.mesh()));
    std::vector<std::size_t> first_bad(number_of_blocks(size), Walk::none);
    for_each_block<ConcurrencyTag>(size, [&](std::size_t block, std::size_t rank, std::size_t) {
      for (auto v : m_walk.vertices_of_block(block)) {
        const Vector_3 p = point(m_point_map, v);
        if (!is_finite(p))
          first_bad[block] = (std::min)(first_bad[block], rank);
        if (m_with_points)
          m_builder.set_point(rank, p);
        ++rank;
      }
    });
    for (std::size_t vertex : first_bad)
      if (vertex != Walk::none)
        throw Invalid_input("the point of vertex " + std::to_string(vertex) + " is not finite");
  }

  void read_block(std::size_t i, Face_block& block) const
  {
    Boundary boundary;
    block.clear(i * block_size);
    const auto range = m_walk.faces_of_block(i);
    for (auto it = range.begin(); it != range.end();) {
      it = read_triangles(it, range.end(), block);
      if (it != range.end()) {
        m_walk.read_boundary(*it++, boundary);
        read_polygon(boundary, block);
      }
    }
  }

  /// Reads faces up to the first one that is no triangle. What the loop uses is at hand in registers. A face is read
  /// from where the mesh begins it and written to where its boundary begins, so that no reading waits for the order.
  template <typename Iterator>
  Iterator read_triangles(Iterator it, Iterator end, Face_block& block) const
  {
    const FaceGraph& mesh = m_walk.mesh();
    const auto rank_of_face = m_walk.rank_of_face();
    const auto rank_of_vertex = m_walk.rank_of_vertex();
    const Point_map point_map = m_point_map;
    const auto put = [&](const auto& v, std::size_t rank, halfedge_descriptor h, Corner& corner) {
      const auto f = face(opposite(h, mesh), mesh);
      const bool is_border = f == boost::graph_traits<FaceGraph>::null_face();
      corner.point = point(point_map, v);
      corner.vertex = Flat_mesh::Index(rank);
      corner.neighbor = is_border ? Corner::no_neighbor : Flat_mesh::Index(rank_of_face(f));
    };

    Corner *const begin = block.places_of_triangles(), *corners = begin;
    for (; it != end; ++it, corners += 4) {
      const halfedge_descriptor a = halfedge(*it, mesh), b = next(a, mesh), c = next(b, mesh);
      if (next(c, mesh) != a)
        break;
      const auto p = target(c, mesh), q = target(a, mesh), r = target(b, mesh);
      const std::size_t rank_of_p = rank_of_vertex(p), rank_of_q = rank_of_vertex(q), rank_of_r = rank_of_vertex(r);
      const auto place = places_in_triangle(rank_of_p, rank_of_q, rank_of_r);
      put(p, rank_of_p, a, corners[place[0]]);
      put(q, rank_of_q, b, corners[place[1]]);
      put(r, rank_of_r, c, corners[place[2]]);
    }
    block.add_triangles(std::size_t(corners - begin) / 4);
    return it;
  }

  /// The places of p, q and r in a boundary that begins at the lowest of these ranks. Which it is cannot be predicted:
  /// so there is no branch.
  static const unsigned char* places_in_triangle(std::size_t p, std::size_t q, std::size_t r)
  {
    static constexpr unsigned char places[8][3] = {{0, 1, 2}, {2, 0, 1}, {}, {2, 0, 1},
                                                   {0, 1, 2}, {}, {1, 2, 0}, {1, 2, 0}};
    return places[unsigned(q < p) + 2 * unsigned(r < p) + 4 * unsigned(r < q)];
  }

  void read_polygon(const Boundary& boundary, Face_block& block) const
  {
    const std::size_t n = boundary.size();
    Corner* const c = block.add_polygon(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t neighbor = m_walk.opposite_face_rank(boundary[i]);
      c[i].point = point(m_point_map, source(boundary[i], m_walk.mesh()));
      c[i].vertex = Flat_mesh::Index(m_walk.source_rank(boundary[i]));
      c[i].neighbor = neighbor == Walk::none ? Corner::no_neighbor : Flat_mesh::Index(neighbor);
    }
  }

  void set_faces(const Face_block& block)
  {
    block.for_each_area_vector([this](std::size_t face, const Vector_3& area_vector, double squared_longest_edge) {
      m_builder.set_face(face, area_vector, squared_longest_edge);
    });
  }

  /// Returns the number of edges.
  std::size_t set_edges_and_corners(std::size_t i, const Place& place, Face_block& block)
  {
    if (m_with_points)
      m_builder.set_corners(place.corner, block);
    const std::size_t number = block.with_edges([&](const Side_edge* edges, std::size_t n) {
      m_builder.set_edges(place.edge, edges, n, block);
    });
    if constexpr (has_constraints)
      m_walk.for_each_dual_edge_of_block(i, place.edge, [&](halfedge_descriptor h, std::size_t dual_edge) {
        if (get(m_is_constrained, edge(h, m_walk.mesh())))
          m_builder.set_constrained(dual_edge);
      });
    return number;
  }

  const Walk& m_walk;
  Point_map m_point_map;
  Constraint_map m_is_constrained;
  bool m_with_points;
  Flat_mesh_builder m_builder;
};

/// The flat mesh of a face graph and its constrained edges.
/// \throws Invalid_input if a point is not finite
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph, typename Pack>
Flat_mesh read_flat_mesh(const Mesh_walk<FaceGraph, Pack>& walk, const Pack& np,
                         Flat_mesh::Content content = Flat_mesh::Content::ANGLES)
{
  return Flat_mesh_reader<ConcurrencyTag, FaceGraph, Pack>(walk, np, content).read();
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READ_FLAT_MESH_H
