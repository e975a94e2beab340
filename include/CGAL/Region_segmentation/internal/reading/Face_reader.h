// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_FACE_READER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_FACE_READER_H

#include <CGAL/Region_segmentation/internal/reading/Face_block.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/reading/Vertex_points.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Reads the faces of blocks of a face graph.
template <typename FaceGraph, typename Pack>
class Face_reader
{
  using Traversal = Mesh_traversal<FaceGraph, Pack>;
  using Boundary = typename Traversal::Boundary;
  using Traits = boost::graph_traits<FaceGraph>;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;

public:
  Face_reader(const Traversal& traversal, const Vertex_points<FaceGraph, Pack>& points)
    : m_traversal(traversal), m_points(points)
  {}

  /// Replaces the contents of `faces` by the faces of a block.
  void read(std::size_t block, Face_block& faces) const
  {
    Boundary boundary;
    faces.clear(block * block_size);
    const auto range = m_traversal.faces_of_block(block);
    for (auto it = range.begin(); it != range.end();) {
      it = read_triangles(it, range.end(), faces);
      if (it != range.end()) {
        m_traversal.read_boundary(*it++, boundary);
        read_polygon(boundary, faces);
      }
    }
  }

private:
  /// Reads faces up to the first one that is not a triangle. Loop variables are kept in registers. A face is read from
  /// the halfedge of the mesh on and rotated on writing, so that reads do not depend on the order of its corners.
  template <typename Iterator>
  Iterator read_triangles(Iterator it, Iterator end, Face_block& block) const
  {
    const FaceGraph& mesh = m_traversal.mesh();
    const auto rank_of_face = m_traversal.rank_of_face();
    const auto rank_of_vertex = m_traversal.rank_of_vertex();
    const auto point = m_points;
    const auto put = [&](const auto& v, std::size_t rank, halfedge_descriptor h, Corner& corner) {
      const auto f = face(opposite(h, mesh), mesh);
      const bool is_border = f == Traits::null_face();
      corner.point = point(v);
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

  /// The places of p, q and r in a boundary that begins at the lowest of these ranks. Branch-free, since the lowest is
  /// unpredictable.
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
      const std::size_t neighbor = m_traversal.opposite_face_rank(boundary[i]);
      c[i].point = m_points(source(boundary[i], m_traversal.mesh()));
      c[i].vertex = Flat_mesh::Index(m_traversal.source_rank(boundary[i]));
      c[i].neighbor = neighbor == Traversal::none ? Corner::no_neighbor : Flat_mesh::Index(neighbor);
    }
  }

  const Traversal& m_traversal;
  const Vertex_points<FaceGraph, Pack> m_points;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_FACE_READER_H
