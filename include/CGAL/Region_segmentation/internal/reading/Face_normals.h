// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_FACE_NORMALS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_FACE_NORMALS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/reading/Area_vector_sum.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/reading/Signed_volumes.h>
#include <CGAL/Region_segmentation/internal/reading/Vertex_points.h>
#include <CGAL/Region_segmentation/internal/reading/find_unit.h>
#include <CGAL/Region_segmentation/internal/reading/for_each_edge.h>
#include <CGAL/Region_segmentation/internal/reading/normals.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The normals of the faces of a mesh, and the angles and signs of its edges, with the same bits as in a `Flat_mesh`: for
/// stages that need neither the order of the dual edges nor lengths and areas.
///
/// Bytes: 24 per face, 32 while they are read.
template <typename FaceGraph, typename Pack>
class Face_normals
{
  using Traversal = Mesh_traversal<FaceGraph, Pack>;
  using Points = Vertex_points<FaceGraph, Pack>;
  using Edge = Mesh_edge<FaceGraph>;

public:
  /// \throws Invalid_input if a point is not finite
  template <typename ConcurrencyTag>
  Face_normals(const Traversal& traversal, const Pack& np, const Execution<ConcurrencyTag>& execution)
    : m_mesh(traversal.mesh())
    , m_points(traversal.mesh(), np, 1 / find_unit<ConcurrencyTag>(traversal, np))
    , m_normals(traversal.number_of_faces())
    , m_has_degenerate_faces(number_of_blocks(m_normals.size()))
  {
    Signed_volumes volumes(m_normals.size());
    for_each_block(
      execution, number_of_blocks(m_normals.size()),
      [&](std::size_t, std::size_t first_block, std::size_t last_block) {
        Corners corners(block_size);
        for (std::size_t block = first_block; block < last_block; ++block)
          read_block(traversal, block, corners, volumes);
      },
      blocks_in_range);
    if (volumes.sum() < 0)
      find_turned_faces(traversal, volumes);
  }

  bool is_degenerate(std::size_t face) const
  {
    return m_has_degenerate_faces[face / block_size] && std::isnan(m_normals[face].x);
  }

  /// The computed cosine of the deviation of an edge between two faces; not a number beside a degenerate face.
  double cosine(const Edge& e) const { return dot(m_normals[e.face], m_normals[e.other_face]); }

  /// `Flat_mesh::CONVEX`, `Flat_mesh::CONCAVE` or 0.
  std::uint8_t sign(const Edge& e) const
  {
    const bool is_first_higher = e.face > e.other_face;
    const auto h = is_first_higher != is_turned(e.face) ? e.halfedge : opposite(e.halfedge, m_mesh);
    const std::size_t higher = is_first_higher ? e.face : e.other_face, lower = is_first_higher ? e.other_face : e.face;
    return sign_of_edge(m_normals[higher], m_normals[lower], direction(h));
  }

  /// In the unit of a `Flat_mesh`.
  template <typename Halfedge>
  double length(const Halfedge& h) const
  {
    return norm(direction(h));
  }

private:
  template <typename Halfedge>
  Double_3 direction(const Halfedge& h) const
  {
    return m_points(target(h, m_mesh)) - m_points(source(h, m_mesh));
  }

  /// Whether the face belongs to a component that is inside out.
  bool is_turned(std::size_t face) const { return !m_is_turned.empty() && m_is_turned[face]; }

  /// Of triangles, from the vertex of lowest rank on.
  using Corners = std::vector<std::array<typename boost::graph_traits<FaceGraph>::vertex_descriptor, 3>>;

  /// First the corners of all triangles in a row, then their points: iterations of short loops overlap, which hides the
  /// latency of memory.
  void read_block(const Traversal& traversal, std::size_t block, Corners& corners, Signed_volumes& volumes)
  {
    const auto range = traversal.faces_of_block(block);
    const std::size_t first = block * block_size;
    const auto points = m_points; // in registers
    typename Traversal::Boundary boundary;
    std::size_t face = first;
    for (auto it = range.begin(); it != range.end();) {
      std::size_t n = 0;
      it = read_corners(traversal, it, range.end(), corners, n);
      for (std::size_t i = 0; i < n; ++i)
        set_face(face++, 3, [&](std::size_t j) { return points(corners[i][j]); }, volumes);
      if (it != range.end()) {
        traversal.read_boundary(*it++, boundary);
        set_face(face++, boundary.size(), [&](std::size_t j) { return points(source(boundary[j], m_mesh)); }, volumes);
      }
    }
    for (std::size_t f = first; f < face; ++f)
      m_has_degenerate_faces[block] |= std::isnan(m_normals[f].x);
  }

  /// Up to the first face that is not a triangle; `n`: the number of triangles.
  template <typename Iterator>
  Iterator read_corners(const Traversal& traversal, Iterator it, Iterator end, Corners& corners, std::size_t& n) const
  {
    const FaceGraph& mesh = m_mesh;
    const auto rank_of_vertex = traversal.rank_of_vertex();
    for (; it != end; ++it) {
      const auto a = halfedge(*it, mesh), b = next(a, mesh), c = next(b, mesh);
      if (next(c, mesh) != a)
        break;
      const auto p = target(c, mesh), q = target(a, mesh), r = target(b, mesh);
      const std::size_t rank_of_p = rank_of_vertex(p), rank_of_q = rank_of_vertex(q), rank_of_r = rank_of_vertex(r);
      const bool is_r_first = rank_of_r < (std::min)(rank_of_p, rank_of_q);
      const bool is_q_first = !is_r_first && rank_of_q < rank_of_p;
      corners[n++] = {is_r_first ? r : is_q_first ? q : p, is_r_first ? p : is_q_first ? r : q,
                      is_r_first ? q : is_q_first ? p : r};
    }
    return it;
  }

  /// `point(i)`: of the i-th of `n` corners.
  template <typename Point>
  void set_face(std::size_t face, std::size_t n, const Point& point, Signed_volumes& volumes)
  {
    const Double_3 first = point(0);
    Area_vector_sum sum(first, point(1));
    for (std::size_t i = 2; i < n; ++i)
      sum.add(point(i));
    const Double_3 area_vector = sum.area_vector();
    volumes.set(face, first, area_vector);
    m_normals[face] = unit_normal(area_vector, norm(area_vector), sum.squared_longest_edge(), not_a_number);
  }

  /// `volumes`: with a sum below 0; components are turned if the surface as a whole is closed.
  void find_turned_faces(const Traversal& traversal, const Signed_volumes& volumes)
  {
    bool is_closed = true;
    Lowest_root_forest components(m_normals.size());
    for_each_edge(traversal, Execution<>(), [&](const Edge& e) {
      if (e.has_two_faces())
        components.unite(Flat_mesh::Index(e.face), Flat_mesh::Index(e.other_face));
      else if (e.face != Edge::no_face || e.other_face != Edge::no_face)
        is_closed = false;
    });
    if (!is_closed)
      return;
    m_is_turned.resize(m_normals.size());
    for (const auto face : volumes.faces_inside_out(components.take_partition()))
      m_is_turned[face] = true;
  }

  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  /// The normal of a degenerate face, so that none of its edges is sharp.
  static constexpr Double_3 not_a_number = {nan, nan, nan};

  const FaceGraph& m_mesh;
  const Points m_points;
  Large_array<Double_3> m_normals;                  // by face
  std::vector<std::uint8_t> m_has_degenerate_faces; // by block
  std::vector<bool> m_is_turned;                    // by face; empty if none is
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_FACE_NORMALS_H
