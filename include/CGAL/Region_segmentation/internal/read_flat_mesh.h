// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READ_FLAT_MESH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READ_FLAT_MESH_H

#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/Flat_mesh_builder.h>
#include <CGAL/Region_segmentation/internal/Mesh_walk.h>
#include <CGAL/Region_segmentation/internal/Face_reader.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

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
/// The dual edges of a face, those to lower faces, need the normals of these, and a place among the others. In
/// sequence both are known. In parallel the edges are counted first; each thread reads ranges of blocks, and where
/// an edge leads to a face below its range, what needs the normal comes at the end.
template <typename ConcurrencyTag, typename FaceGraph, typename Pack>
class Flat_mesh_reader
{
  using Walk = Mesh_walk<FaceGraph, Pack>;
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
    , m_faces(walk, np)
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
      return m_builder.finish(read_in_parallel());
    else
      return m_builder.finish(read_in_sequence());
  }

private:
  /// Of what belongs to the faces of a block, in the arrays.
  struct Place
  {
    std::size_t edge, corner;
  };

  using Late_edges = std::vector<Flat_mesh_builder::Late_edge>;

  /// Returns the number of dual edges.
  std::size_t read_in_sequence()
  {
    Place end = {0, 0};
    Face_block faces;
    Late_edges none;
    for (std::size_t block = 0; block < number_of_blocks(m_walk.number_of_faces()); ++block) {
      const std::size_t edges = read_block(block, end, 0, faces, none);
      end = {end.edge + edges, end.corner + faces.number_of_corners()};
    }
    return end.edge;
  }

  /// Returns the number of dual edges.
  std::size_t read_in_parallel()
  {
    std::vector<Place> places(number_of_blocks(m_walk.number_of_faces()));
    const Place end = count_edges_and_corners(places);
    std::vector<Late_edges> late_edges(number_of_blocks(places.size(), blocks_in_range));
    for_each_block<ConcurrencyTag>(
      places.size(),
      [&](std::size_t range, std::size_t begin, std::size_t end) {
        Face_block faces;
        for (std::size_t block = begin; block < end; ++block)
          read_block(block, places[block], begin * block_size, faces, late_edges[range]);
      },
      blocks_in_range);
    for_each_block<ConcurrencyTag>(
      late_edges.size(),
      [&](std::size_t range, std::size_t, std::size_t) {
        for (const auto& edge : late_edges[range])
          m_builder.set_late_edge(edge);
      },
      1);
    return end.edge;
  }

  /// Finds the place of every block, and that behind the last one.
  Place count_edges_and_corners(std::vector<Place>& places) const
  {
    for_each_block<ConcurrencyTag>(
      m_walk.number_of_faces(), [&](std::size_t block, std::size_t rank, std::size_t) {
        const FaceGraph& mesh = m_walk.mesh();
        const auto rank_of_face = m_walk.rank_of_face();
        Place size = {0, 0};
        for (auto f : m_walk.faces_of_block(block)) {
          const halfedge_descriptor start = halfedge(f, mesh);
          halfedge_descriptor h = start;
          do {
            const auto across = face(opposite(h, mesh), mesh);
            size.edge += across != boost::graph_traits<FaceGraph>::null_face() && rank_of_face(across) < rank;
            ++size.corner;
            h = next(h, mesh);
          } while (h != start);
          ++rank;
        }
        places[block] = size;
      });
    Place end = {0, 0};
    for (Place& place : places) {
      const Place size = std::exchange(place, end);
      end = {end.edge + size.edge, end.corner + size.corner};
    }
    return end;
  }

  void read_points()
  {
    const std::size_t size = m_walk.number_of_vertices();
    if (m_with_points)
      m_builder.resize_points(size, num_halfedges(m_walk.mesh()));
    std::vector<std::size_t> first_bad(number_of_blocks(size), Walk::none);
    for_each_block<ConcurrencyTag>(size, [&](std::size_t block, std::size_t rank, std::size_t) {
      for (auto v : m_walk.vertices_of_block(block)) {
        const Vector_3 p = m_faces.point(v);
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

  /// Reads the faces of a block, and their edges and corners to `place`. Returns the number of edges.
  std::size_t read_block(std::size_t block, const Place& place, std::size_t first_known_face, Face_block& faces,
                         Late_edges& late_edges)
  {
    m_faces.read(block, faces);
    faces.for_each_area_vector([this](std::size_t face, const Vector_3& area_vector, double squared_longest_edge) {
      m_builder.set_face(face, area_vector, squared_longest_edge);
    });
    if (m_with_points)
      m_builder.set_corners(place.corner, faces);
    const std::size_t number = faces.collect_edges();
    m_builder.set_edges(place.edge, faces, first_known_face, late_edges);
    if constexpr (has_constraints)
      m_walk.for_each_dual_edge_of_block(block, place.edge, [&](halfedge_descriptor h, std::size_t dual_edge) {
        if (get(m_is_constrained, edge(h, m_walk.mesh())))
          m_builder.set_constrained(dual_edge);
      });
    return number;
  }

  const Walk& m_walk;
  Face_reader<FaceGraph, Pack> m_faces;
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
