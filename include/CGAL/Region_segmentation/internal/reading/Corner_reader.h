// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_CORNER_READER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_CORNER_READER_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/reading/Area_vector_sum.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/reading/Vertex_points.h>
#include <CGAL/Region_segmentation/internal/reading/find_unit.h>
#include <CGAL/Region_segmentation/internal/reading/normals.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>
#include <CGAL/Region_segmentation/internal/support/unit_of_coordinates.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The points of the corners of faces, in the unit of a `Flat_mesh` and from the vertex of lowest rank on, as there: for
/// stages that read no flat mesh.
template <typename FaceGraph, typename Pack>
class Corner_reader
{
  using Traversal = Mesh_traversal<FaceGraph, Pack>;

public:
  /// \throws Invalid_input if a point is not finite
  template <typename ConcurrencyTag>
  Corner_reader(const Traversal& traversal, const Pack& np, const Execution<ConcurrencyTag>&)
    : Corner_reader(traversal, np, find_largest_coordinate<ConcurrencyTag>(traversal, np))
  {}

  /// Calls `f(face, n, point)` for all faces, `point(i)` being the i-th of `n` corners; in parallel within ranges of blocks.
  template <typename ConcurrencyTag, typename F>
  void for_each_face(const Execution<ConcurrencyTag>& execution, const F& f) const
  {
    for_each_block(
      execution, number_of_blocks(m_traversal.number_of_faces()),
      [&](std::size_t, std::size_t first_block, std::size_t last_block) {
        Corners corners(block_size);
        for (std::size_t block = first_block; block < last_block; ++block)
          read_block(block, corners, f);
      },
      blocks_in_range);
  }

  /// No face of a larger area is degenerate. So the longest edges of few faces are computed (2.7 of 20 ns per face).
  double certain_area() const { return m_certain_area; }

  /// Along a halfedge.
  template <typename Halfedge>
  Double_3 direction(const Halfedge& h) const
  {
    return m_points(target(h, m_traversal.mesh())) - m_points(source(h, m_traversal.mesh()));
  }

private:
  Corner_reader(const Traversal& traversal, const Pack& np, double largest_coordinate)
    : Corner_reader(traversal, np, largest_coordinate, 1 / unit_of_coordinates(largest_coordinate))
  {}

  Corner_reader(const Traversal& traversal, const Pack& np, double largest_coordinate, double scale)
    : m_traversal(traversal)
    , m_points(traversal.mesh(), np, scale)
    , m_certain_area(internal::certain_area(scale * largest_coordinate))
  {}

  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  /// Of triangles, from the vertex of lowest rank on.
  using Corners = std::vector<std::array<Vertex, 3>>;

  /// First the corners of all triangles in a row, then their points: iterations of short loops overlap, which hides the
  /// latency of memory.
  template <typename F>
  void read_block(std::size_t block, Corners& corners, F f) const
  {
    const auto range = m_traversal.faces_of_block(block);
    const FaceGraph& mesh = m_traversal.mesh();
    const auto points = m_points; // in registers
    typename Traversal::Boundary boundary;
    std::size_t face = block * block_size;
    for (auto it = range.begin(); it != range.end();) {
      std::size_t n = 0;
      it = read_corners(it, range.end(), corners, n);
      for (std::size_t i = 0; i < n; ++i)
        f(face++, 3, [&](std::size_t j) { return points(corners[i][j]); });
      if (it != range.end()) {
        m_traversal.read_boundary(*it++, boundary);
        f(face++, boundary.size(), [&](std::size_t j) { return points(source(boundary[j], mesh)); });
      }
    }
  }

  /// Up to the first face that is not a triangle; `n`: the number of triangles.
  template <typename Iterator>
  Iterator read_corners(Iterator it, Iterator end, Corners& corners, std::size_t& n) const
  {
    const FaceGraph& mesh = m_traversal.mesh();
    const auto rank_of_vertex = m_traversal.rank_of_vertex();
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

  const Traversal& m_traversal;
  const Vertex_points<FaceGraph, Pack> m_points;
  const double m_certain_area;
};

/// Of `n` corners.
template <typename Point>
Double_3 area_vector_of(std::size_t n, const Point& point)
{
  Area_vector_sum sum(point(0), point(1));
  for (std::size_t i = 2; i < n; ++i)
    sum.add(point(i));
  return sum.area_vector();
}

template <typename Point>
double squared_longest_edge(std::size_t n, const Point& point)
{
  double result = squared_norm(point(n - 1) - point(0));
  for (std::size_t i = 1; i < n; ++i)
    result = (std::max)(result, squared_norm(point(i) - point(i - 1)));
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_CORNER_READER_H
