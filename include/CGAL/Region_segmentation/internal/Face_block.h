// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACE_BLOCK_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACE_BLOCK_H

#include <CGAL/Region_segmentation/internal/Area_vector_sum.h>
#include <CGAL/Region_segmentation/internal/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/Large_array.h>
#include <CGAL/Region_segmentation/internal/Vector_3.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

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

  Vector_3 point;
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

/// The faces of a block as they are read. What is computed of them is computed in short loops over all: a face
/// waits longer for points, roots and divisions than its work takes, and others can be worked on meanwhile.
class Face_block
{
  using Index = Flat_mesh::Index;

public:
  Face_block() : m_first_sides(block_size + 1), m_corners(5 * block_size) {}

  void clear(std::size_t first_face)
  {
    m_first_face = first_face;
    m_number_of_faces = 0;
    m_first_sides[0] = 0;
    m_polygons.clear();
    m_constrained_sides.clear();
  }

  /// Takes in the next face; returns the places of its `n` corners. There are at most `block_size` faces.
  Corner* add_face(std::size_t n)
  {
    const std::size_t first = m_first_sides[m_number_of_faces], end = first + n + 1;
    if (m_corners.size() < end)
      m_corners.resize(2 * end);
    if (n != 3)
      m_polygons.push_back(Index(m_number_of_faces));
    m_first_sides[++m_number_of_faces] = Index(end);
    return m_corners.data() + first;
  }

  /// Says of a side of the face taken in last that its edge is constrained.
  void set_constrained(std::size_t position)
  {
    m_constrained_sides.push_back(m_first_sides[m_number_of_faces - 1] + Index(position));
  }

  std::size_t first_face() const { return m_first_face; }
  std::size_t number_of_faces() const { return m_number_of_faces; }
  std::size_t number_of_corners() const { return m_first_sides[m_number_of_faces] - m_number_of_faces; }

  /// Of the i-th face of the block. Behind its corners there is a place for the first one again.
  std::size_t number_of_corners(std::size_t i) const { return m_first_sides[i + 1] - m_first_sides[i] - 1; }
  const Corner* corners(std::size_t i) const { return m_corners.data() + m_first_sides[i]; }

  bool is_constrained(std::size_t side) const
  {
    return std::binary_search(m_constrained_sides.begin(), m_constrained_sides.end(), Index(side));
  }

  /// Calls `f(face, area_vector, squared_longest_edge)` for all faces.
  template <typename F>
  void for_each_area_vector(const F& f) const
  {
    for (std::size_t i = 0; i < m_number_of_faces; ++i) {
      const Corner* const c = corners(i);
      Area_vector_sum sum(c[0].point, c[1].point);
      sum.add(c[2].point);
      for (std::size_t j = 3; j < number_of_corners(i); ++j)
        sum.add(c[j].point);
      f(m_first_face + i, sum.area_vector(), sum.squared_longest_edge());
    }
  }

  /// How many dual edges lead from the faces to lower ones.
  std::size_t count_edges() const
  {
    std::size_t n = 0;
    for (std::size_t i = 0; i < m_number_of_faces; ++i)
      for (std::size_t j = 0; j < number_of_corners(i); ++j)
        n += corners(i)[j].neighbor < m_first_face + i;
    return n;
  }

  /// Calls `f(edges, n)` with these dual edges, in order. The points are closed then: `direction()` can be asked.
  template <typename F>
  void with_edges(const F& f)
  {
    m_edges.resize(number_of_corners() + 3);
    Side_edge* end = m_edges.data();
    std::size_t begin_face = 0;
    for (Index polygon : m_polygons) {
      end = put_triangles(begin_face, polygon, end);
      end = put_polygon(polygon, end);
      begin_face = polygon + 1;
    }
    end = put_triangles(begin_face, m_number_of_faces, end);
    f(m_edges.data(), std::size_t(end - m_edges.data()));
  }

  /// Along the halfedge of a side.
  Vector_3 direction(std::size_t side) const { return m_corners[side + 1].point - m_corners[side].point; }

private:
  static std::uint64_t key(std::size_t face, std::size_t side) { return (std::uint64_t(face) << 32) | side; }

  /// Puts the edges of triangles from `end` on; returns the new end. Which sides of a triangle lead to lower faces,
  /// and in which order, cannot be predicted: so there is no branch. All three are written, those that lead to none
  /// behind the others, where the next face replaces them.
  Side_edge* put_triangles(std::size_t begin_face, std::size_t end_face, Side_edge* end)
  {
    constexpr std::uint64_t none = (std::numeric_limits<std::uint64_t>::max)();
    std::size_t side = m_first_sides[begin_face];
    for (std::size_t i = begin_face; i < end_face; ++i, side += 4) {
      Corner* const c = m_corners.data() + side;
      c[3].point = c[0].point;
      const Index face = Index(m_first_face + i), p = c[0].neighbor, q = c[1].neighbor, r = c[2].neighbor;
      std::uint64_t a = p < face ? key(p, side) : none, b = q < face ? key(q, side + 1) : none,
                    d = r < face ? key(r, side + 2) : none;
      order(a, b);
      order(b, d);
      order(a, b);
      end[0] = {a, face};
      end[1] = {b, face};
      end[2] = {d, face};
      end += (p < face) + (q < face) + (r < face);
    }
    return end;
  }

  static void order(std::uint64_t& a, std::uint64_t& b)
  {
    const std::uint64_t lower = (std::min)(a, b), higher = (std::max)(a, b);
    a = lower;
    b = higher;
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
  std::vector<Index> m_first_sides; // by the face, and the end
  std::vector<Index> m_polygons;    // the faces that are no triangles
  std::vector<Index> m_constrained_sides;
  Large_array<Corner> m_corners;
  Large_array<Side_edge> m_edges;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACE_BLOCK_H
