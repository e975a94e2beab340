// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_FACE_BLOCK_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_FACE_BLOCK_H

#include <CGAL/Region_segmentation/internal/reading/Area_vector_sum.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A corner of a face, and the side that leaves it.
struct Corner
{
  static constexpr Flat_mesh::Index no_neighbor = (std::numeric_limits<Flat_mesh::Index>::max)();

  Double_3 point;
  Flat_mesh::Index vertex;
  Flat_mesh::Index neighbor; // the face across the side
};

/// A dual edge, and the side of its higher face that leads across it.
struct Side_edge
{
  std::uint64_t lower_and_side; // compared as one number
  Flat_mesh::Index higher;

  Flat_mesh::Index lower() const { return Flat_mesh::Index(lower_and_side >> 32); }
  Flat_mesh::Index side() const { return Flat_mesh::Index(lower_and_side); }
};

/// The faces of a block as they are read, each with its corners from the one of lowest number on. Values are computed
/// in short loops over all faces: the computation is bound by the latency of points, roots and divisions, and short
/// loops let iterations overlap.
class Face_block
{
  using Index = Flat_mesh::Index;

public:
  Face_block() : m_first_sides(block_size + 1) {}

  void clear(std::size_t first_face)
  {
    m_first_face = first_face;
    m_number_of_faces = 0;
    m_first_sides[0] = 0;
    m_polygons.clear();
  }

  /// \name Faces in order
  /// There are at most `block_size` of them. The corners of each are followed by a copy of the first one.
  /// @{

  /// The places for the corners of subsequent triangles, four for each of them.
  Corner* places_of_triangles() { return places(4 * (block_size - m_number_of_faces)); }

  /// Adds triangles whose corners are in their places.
  void add_triangles(std::size_t n)
  {
    Index* const first_sides = &m_first_sides[m_number_of_faces];
    const Index first = first_sides[0];
    for (std::size_t i = 1; i <= n; ++i)
      first_sides[i] = first + Index(4 * i);
    m_number_of_faces += n;
  }

  /// Adds a face; returns the places of its `n` corners.
  Corner* add_polygon(std::size_t n)
  {
    Corner* const corners = places(n + 1);
    m_polygons.push_back(m_number_of_faces);
    m_first_sides[m_number_of_faces + 1] = m_first_sides[m_number_of_faces] + Index(n + 1);
    ++m_number_of_faces;
    return corners;
  }
  /// @}

  std::size_t first_face() const { return m_first_face; }
  std::size_t number_of_faces() const { return m_number_of_faces; }
  std::size_t number_of_corners() const { return m_first_sides[m_number_of_faces] - m_number_of_faces; }

  /// Of the i-th face of the block.
  std::size_t number_of_corners(std::size_t i) const { return m_first_sides[i + 1] - m_first_sides[i] - 1; }
  const Corner* corners(std::size_t i) const { return m_corners.data() + m_first_sides[i]; }

  /// Calls `f(face, first_point, area_vector, squared_longest_edge)` for all faces.
  template <typename F>
  void for_each_area_vector(const F& f) const
  {
    for (std::size_t i = 0; i < m_number_of_faces; ++i) {
      const Corner* const c = corners(i);
      Area_vector_sum sum(c[0].point, c[1].point);
      sum.add(c[2].point);
      for (std::size_t j = 3; j < number_of_corners(i); ++j)
        sum.add(c[j].point);
      f(m_first_face + i, c[0].point, sum.area_vector(), sum.squared_longest_edge());
    }
  }

  /// Finds the dual edges from the faces to lower ones, in order; returns their number.
  std::size_t collect_edges()
  {
    m_edges.resize(number_of_corners() + 3);
    Side_edge* end = m_edges.data();
    std::size_t begin_face = 0;
    for (std::size_t polygon : m_polygons) {
      end = put_triangles(begin_face, polygon, end);
      end = put_polygon(polygon, end);
      begin_face = polygon + 1;
    }
    end = put_triangles(begin_face, m_number_of_faces, end);
    m_edges.resize(std::size_t(end - m_edges.data()));
    return m_edges.size();
  }

  /// \name After `collect_edges()`
  /// @{
  const Large_array<Side_edge>& edges() const { return m_edges; }
  /// Along the halfedge of a side.
  Double_3 direction(std::size_t side) const { return m_corners[side + 1].point - m_corners[side].point; }
  /// @}

private:
  Corner* places(std::size_t n)
  {
    const std::size_t first = m_first_sides[m_number_of_faces];
    if (m_corners.size() < first + n)
      m_corners.resize((std::max)(first + n, 2 * m_corners.size()));
    return m_corners.data() + first;
  }

  static std::uint64_t key(Index lower, std::size_t side) { return (std::uint64_t(lower) << 32) | side; }

  /// The key of a side, or the highest number if it does not lead to a lower face.
  static std::uint64_t key_or_none(Index neighbor, std::size_t side, Index face)
  {
    return key(neighbor, side) | (std::uint64_t(0) - std::uint64_t(neighbor >= face));
  }

  /// Writes the edges of triangles from `end` on; returns the new end. Which sides of a triangle lead to lower faces,
  /// and in which order, is unpredictable, so the code is branch-free: all three are written, those that lead to no
  /// lower face last, where the next face overwrites them.
  Side_edge* put_triangles(std::size_t begin_face, std::size_t end_face, Side_edge* end)
  {
    std::size_t side = m_first_sides[begin_face];
    for (std::size_t i = begin_face; i < end_face; ++i, side += 4) {
      Corner* const corners = m_corners.data() + side;
      corners[3].point = corners[0].point;
      const Index face = Index(m_first_face + i);
      const Index p = corners[0].neighbor, q = corners[1].neighbor, r = corners[2].neighbor;
      const std::uint64_t a = key_or_none(p, side, face), b = key_or_none(q, side + 1, face),
                          c = key_or_none(r, side + 2, face);
      const unsigned b_a = b < a, c_a = c < a, c_b = c < b;
      end[b_a + c_a] = {a, face};
      end[1 - b_a + c_b] = {b, face};
      end[2 - c_a - c_b] = {c, face};
      end += (p < face) + (q < face) + (r < face);
    }
    return end;
  }

  Side_edge* put_polygon(std::size_t i, Side_edge* end)
  {
    const std::size_t first = m_first_sides[i], n = number_of_corners(i);
    const Index face = Index(m_first_face + i);
    m_corners[first + n].point = m_corners[first].point;
    Side_edge* const begin = end;
    for (std::size_t side = first; side < first + n; ++side)
      if (m_corners[side].neighbor < face)
        *end++ = {key(m_corners[side].neighbor, side), face};
    std::sort(begin, end,
              [](const Side_edge& a, const Side_edge& b) { return a.lower_and_side < b.lower_and_side; });
    return end;
  }

  std::size_t m_first_face = 0, m_number_of_faces = 0;
  std::vector<Index> m_first_sides;    // by the face, and the end
  std::vector<std::size_t> m_polygons; // the faces that were not added as triangles
  Large_array<Corner> m_corners;
  Large_array<Side_edge> m_edges;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_FACE_BLOCK_H
