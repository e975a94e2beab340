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
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Reads a face graph, once, into a `Flat_mesh`.
///
/// The dual edges of a face, those to higher faces, need the normals of these. In sequence faces are read from
/// the last one down, each with its edges, and the arrays of edges are filled from their end. In parallel all
/// faces are read and their edges counted, then all edges are read.
template <typename ConcurrencyTag, typename FaceGraph, typename Pack>
class Flat_mesh_reader
{
  using Walk = Mesh_walk<FaceGraph, Pack>;
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
          std::size_t end = ends[block];
          for_each_face_down(block, [&](std::size_t rank, const auto& around, Scratch& scratch) {
            end = read_edges_of_face(rank, around, scratch, end, is_constrained);
          });
        });
    } else
      for (std::size_t block = number_of_blocks(m_walk.number_of_faces()); block-- > 0;)
        for_each_face_down(block, [&](std::size_t rank, const auto& around, Scratch& scratch) {
          m_builder.set_face(rank, area_of(around));
          edge = read_edges_of_face(rank, around, scratch, edge, is_constrained);
        });
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

  /// The area of a face, from its vertex of lowest number on.
  template <typename Boundary>
  Area_vector_sum area_of(const Boundary& around) const
  {
    const FaceGraph& mesh = m_walk.mesh();
    Area_vector_sum sum(point(target(around.back(), mesh)), point(target(around[0], mesh)));
    for (std::size_t i = 1; i + 1 < around.size(); ++i)
      sum.add(point(target(around[i], mesh)));
    return sum;
  }

  /// Calls `f(rank, boundary, scratch)` for the faces of a block, the last one first.
  template <typename F>
  void for_each_face_down(std::size_t block, const F& f) const
  {
    const auto range = m_walk.faces_of_block(block);
    const std::vector<typename Walk::face_descriptor> faces(range.begin(), range.end());
    Scratch scratch;
    for (std::size_t i = faces.size(); i-- > 0;)
      m_walk.with_boundary(
        faces[i], scratch, [&](const auto& around) { f(block * block_size + i, around, scratch); });
  }

  /// Reads all faces in parallel; returns the number of their dual edges by block.
  std::vector<std::size_t> read_faces_and_count_edges()
  {
    const std::size_t size = m_walk.number_of_faces();
    std::vector<std::size_t> numbers(number_of_blocks(size));
    for_each_block<ConcurrencyTag>(size, [&](std::size_t block, std::size_t, std::size_t) {
      std::size_t number = 0;
      for_each_face_down(block, [&](std::size_t rank, const auto& around, Scratch&) {
        m_builder.set_face(rank, area_of(around));
        number += m_walk.number_of_higher_neighbors(rank, around);
      });
      numbers[block] = number;
    });
    return numbers;
  }

  /// Reads the dual edges of a face into the places before `end`; returns the first place.
  template <typename Boundary, typename EdgeIsConstrainedMap>
  std::size_t read_edges_of_face(std::size_t rank, const Boundary& around, Scratch& scratch,
                                 std::size_t end, const EdgeIsConstrainedMap& is_constrained)
  {
    const FaceGraph& mesh = m_walk.mesh();
    const auto neighbors = m_walk.higher_neighbors(rank, around, scratch);
    const std::size_t first = end - neighbors.size();
    m_builder.set_first_edge(rank, first);
    for (std::size_t i = 0; i < neighbors.size(); ++i) {
      const std::size_t j = neighbors.position(i);
      const Vector_3 d =
        point(target(around[j], mesh)) - point(target(around[(j ? j : around.size()) - 1], mesh));
      m_builder.set_edge(first + i, rank, neighbors.face_rank(i), d,
                         bool(get(is_constrained, edge(around[j], mesh))));
    }
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
