// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READ_FLAT_MESH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READ_FLAT_MESH_H

#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/Area_vector_sum.h>
#include <CGAL/Region_segmentation/internal/Flat_mesh_builder.h>
#include <CGAL/Region_segmentation/internal/Mesh_walk.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The dual edges of a block of faces, whose place is known when they are counted.
class Edge_buffer
{
public:
  using Edge = Flat_mesh_builder::Edge;

  void clear() { m_size = 0; }
  std::size_t size() const { return m_size; }
  const Edge& operator[](std::size_t i) const { return m_edges[i]; }

  /// The places of the next `n` edges; `add()` says how many of them were used.
  Edge* next(std::size_t n)
  {
    if (m_edges.size() < m_size + n)
      m_edges.resize(2 * (m_size + n));
    return m_edges.data() + m_size;
  }
  void add(std::size_t n) { m_size += n; }

private:
  std::vector<Edge> m_edges;
  std::size_t m_size = 0;
};

/// Reads a face graph, once, into a `Flat_mesh`.
///
/// The dual edges of a face, those to higher faces, need the normals of these. In sequence the blocks of faces
/// are read from the last one down, each with its edges, and the arrays of edges are filled from their end. In
/// parallel all faces are read and their edges counted, then all edges are read.
template <typename ConcurrencyTag, typename FaceGraph, typename Pack>
class Flat_mesh_reader
{
  using Walk = Mesh_walk<FaceGraph, Pack>;
  using Triangle = typename Walk::Triangle;
  using Polygon = typename Walk::Polygon;
  using Scratch = typename Walk::Scratch;
  using Point_map = typename GetVertexPointMap<FaceGraph, Pack>::const_type;

public:
  Flat_mesh_reader(const Walk& walk, const Pack& np, Flat_mesh::Content content)
    : m_walk(walk)
    , m_point_map(CGAL::parameters::choose_parameter(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
        get_const_property_map(vertex_point, walk.mesh())))
    , m_with_points(content == Flat_mesh::Content::ANGLES_AND_POINTS)
    , m_builder(walk.number_of_faces(), num_halfedges(walk.mesh()) / 2)
  {}

  /// \throws Invalid_input if a point is not finite
  template <typename EdgeIsConstrainedMap>
  Flat_mesh read(const EdgeIsConstrainedMap& is_constrained)
  {
    read_points();
    std::size_t edge = m_builder.maximum_number_of_edges();
    if constexpr (is_parallel<ConcurrencyTag>) {
      std::vector<std::size_t> ends = read_faces_and_count_edges();
      for (std::size_t block = ends.size(); block-- > 0;)
        edge -= std::exchange(ends[block], edge);
      for_each_block<ConcurrencyTag>(
        m_walk.number_of_faces(), [&](std::size_t block, std::size_t, std::size_t) {
          Edge_buffer edges;
          for_each_face(
            block, [&](std::size_t rank, const auto& around, const auto& points, Scratch& scratch) {
              collect_edges(rank, around, points, scratch, is_constrained, edges);
            });
          set_edges(ends[block], edges);
        });
    } else {
      Edge_buffer edges;
      for (std::size_t block = number_of_blocks(m_walk.number_of_faces()); block-- > 0;) {
        edges.clear();
        for_each_face(
          block, [&](std::size_t rank, const auto& around, const auto& points, Scratch& scratch) {
            m_builder.set_face(rank, area_of(points));
            collect_edges(rank, around, points, scratch, is_constrained, edges);
          });
        edge = set_edges(edge, edges);
      }
    }
    if (m_with_points)
      read_corners();
    return m_builder.finish(edge);
  }

private:
  Vector_3 point(typename boost::graph_traits<FaceGraph>::vertex_descriptor v) const
  {
    const auto& p = get(m_point_map, v);
    return {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
  }

  void read_points()
  {
    const std::size_t size = m_walk.number_of_vertices();
    if (m_with_points)
      m_builder.resize_points(size);
    std::vector<std::size_t> first_bad(number_of_blocks(size), Walk::none);
    for_each_block<ConcurrencyTag>(size, [&](std::size_t block, std::size_t rank, std::size_t) {
      for (auto v : m_walk.vertices_of_block(block)) {
        const Vector_3 p = point(v);
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

  /// The points at the sources of the halfedges around a face. Those of a triangle are values, which stay in
  /// registers.
  std::array<Vector_3, 3> points_of(const Triangle& around, std::vector<Vector_3>&) const
  {
    const FaceGraph& mesh = m_walk.mesh();
    return {point(target(around[2], mesh)), point(target(around[0], mesh)), point(target(around[1], mesh))};
  }

  const std::vector<Vector_3>& points_of(const Polygon& around, std::vector<Vector_3>& points) const
  {
    points.clear();
    for (auto h : around)
      points.push_back(point(source(h, m_walk.mesh())));
    return points;
  }

  template <typename Points>
  static Area_vector_sum area_of(const Points& points)
  {
    Area_vector_sum sum(points[0], points[1]);
    for (std::size_t i = 2; i < points.size(); ++i)
      sum.add(points[i]);
    return sum;
  }

  /// Calls `f(rank, boundary, points, scratch)` for the faces of a block.
  template <typename F>
  void for_each_face(std::size_t block, const F& f) const
  {
    Scratch scratch;
    std::vector<Vector_3> memory;
    std::size_t rank = block * block_size;
    for (auto face : m_walk.faces_of_block(block)) {
      m_walk.with_boundary(face, scratch, [&](const auto& around) {
        const auto& points = points_of(around, memory);
        f(rank, around, points, scratch);
      });
      ++rank;
    }
  }

  /// Reads all faces in parallel; returns the number of their dual edges by block.
  std::vector<std::size_t> read_faces_and_count_edges()
  {
    const std::size_t size = m_walk.number_of_faces();
    std::vector<std::size_t> numbers(number_of_blocks(size));
    for_each_block<ConcurrencyTag>(size, [&](std::size_t block, std::size_t, std::size_t) {
      std::size_t number = 0;
      for_each_face(block, [&](std::size_t rank, const auto& around, const auto& points, Scratch&) {
        m_builder.set_face(rank, area_of(points));
        number += m_walk.number_of_higher_neighbors(rank, around);
      });
      numbers[block] = number;
    });
    return numbers;
  }

  /// Appends the dual edges of a face, in order.
  template <typename Points, typename EdgeIsConstrainedMap>
  void collect_edges(std::size_t rank, const Polygon& around, const Points& points, Scratch& scratch,
                     const EdgeIsConstrainedMap& is_constrained, Edge_buffer& edges) const
  {
    for (const auto& [higher, i] : m_walk.higher_neighbors(rank, around, scratch)) {
      const Vector_3 d = points[i + 1 < points.size() ? i + 1 : 0] - points[i];
      *edges.next(1) = {Flat_mesh::Index(rank), Flat_mesh::Index(higher), d,
                        bool(get(is_constrained, edge(around[i], m_walk.mesh())))};
      edges.add(1);
    }
  }

  /// The same for a triangle: every side is written to its place in the order, those that lead nowhere
  /// behind the others, where the edges of the next face replace them.
  template <typename EdgeIsConstrainedMap>
  void collect_edges(std::size_t rank, const Triangle& around, const std::array<Vector_3, 3>& points,
                     Scratch& scratch, const EdgeIsConstrainedMap& is_constrained, Edge_buffer& edges) const
  {
    const std::size_t a = m_walk.higher_face_rank(rank, around[0]), b = m_walk.higher_face_rank(rank, around[1]),
                      c = m_walk.higher_face_rank(rank, around[2]);
    if ((a == b && a != Walk::none) || (b == c && b != Walk::none) || (a == c && c != Walk::none)) {
      collect_edges(rank, Polygon(around.begin(), around.end()), points, scratch, is_constrained, edges);
      return;
    }
    const auto make_edge = [&](std::size_t higher, std::size_t i, const Vector_3& d) -> Edge_buffer::Edge {
      return {Flat_mesh::Index(rank), Flat_mesh::Index(higher), d,
              bool(get(is_constrained, edge(around[i], m_walk.mesh())))};
    };
    Edge_buffer::Edge* next = edges.next(3);
    next[(b < a) + (c < a)] = make_edge(a, 0, points[1] - points[0]);
    next[(a <= b) + (c < b)] = make_edge(b, 1, points[2] - points[1]);
    next[(a <= c) + (b <= c)] = make_edge(c, 2, points[0] - points[2]);
    edges.add((a != Walk::none) + (b != Walk::none) + (c != Walk::none));
  }

  /// Puts edges into the places before `end`; returns the first place.
  std::size_t set_edges(std::size_t end, const Edge_buffer& edges)
  {
    const std::size_t first = end - edges.size();
    for (std::size_t i = 0; i < edges.size(); ++i)
      m_builder.set_edge(first + i, edges[i]);
    return first;
  }

  void read_corners()
  {
    typename Walk::Scratch scratch;
    for (auto f : faces(m_walk.mesh()))
      m_walk.with_boundary(f, scratch, [&](const auto& around) {
        m_builder.add_corners(around.size(), [&](std::size_t i) { return m_walk.source_rank(around[i]); });
      });
  }

  const Walk& m_walk;
  Point_map m_point_map;
  bool m_with_points;
  Flat_mesh_builder m_builder;
};

/// The flat mesh of a face graph and its constrained edges.
/// \throws Invalid_input if a point is not finite
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph, typename Pack>
Flat_mesh read_flat_mesh(const Mesh_walk<FaceGraph, Pack>& walk, const Pack& np,
                         Flat_mesh::Content content = Flat_mesh::Content::ANGLES)
{
  using edge_descriptor = typename boost::graph_traits<FaceGraph>::edge_descriptor;
  Flat_mesh_reader<ConcurrencyTag, FaceGraph, Pack> reader(walk, np, content);
  return reader.read(CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained),
    Static_boolean_property_map<edge_descriptor, false>()));
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READ_FLAT_MESH_H
