// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SET_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SET_H

#include <CGAL/Region_segmentation/Part_faces/internal/Face_neighbors.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Marks of elements that are cleared in constant time.
class Element_marks
{
public:
  explicit Element_marks(std::size_t size)
    : m_marks(size, 0)
  {}
  void clear() { ++m_current; }
  bool has(std::size_t i) const { return m_marks[i] == m_current; }
  /// Returns whether the element was not marked before.
  bool mark(std::size_t i)
  {
    const bool is_new = !has(i);
    m_marks[i] = m_current;
    return is_new;
  }

private:
  std::vector<std::uint32_t> m_marks;
  std::uint32_t m_current = 1;
};

/// Faces in the order in which they are added, and their vertices.
class Face_set
{
public:
  using Index = Surface::Index;

  explicit Face_set(const Surface& surface)
    : m_surface(surface)
    , m_face_marks(surface.number_of_faces())
    , m_vertex_marks(surface.number_of_vertices())
    , m_positions(surface.number_of_vertices())
  {}

  void clear()
  {
    m_faces.clear();
    m_points.clear();
    m_face_marks.clear();
    m_vertex_marks.clear();
  }

  /// \pre the set does not have the face
  void add(Index face)
  {
    m_face_marks.mark(face);
    m_faces.push_back(face);
    for (const Index v : m_surface.corners(face))
      if (m_vertex_marks.mark(v)) {
        m_positions[v] = Index(m_points.size());
        m_points.push_back(m_surface.point(v));
      }
  }

  /// Makes it the faces around `seed` in breadth first order, until they have `wanted` vertices:
  /// those beside the i-th one for which `may_cross(i, neighbor)`.
  template <typename MayCross>
  void collect(const Face_neighbors& neighbors, Index seed, std::size_t wanted,
               const MayCross& may_cross)
  {
    clear();
    add(seed);
    for (std::size_t next = 0; next < faces().size() && points().size() < wanted; ++next)
      for (const Face_neighbors::Neighbor& n : neighbors[faces()[next]])
        if (!has(n.face) && may_cross(next, n))
          add(n.face);
  }

  bool has(Index face) const { return m_face_marks.has(face); }
  const std::vector<Index>& faces() const { return m_faces; }
  /// Of the vertices, each once.
  const std::vector<Double_3>& points() const { return m_points; }
  /// The position of a vertex of the faces in `points()`.
  Index position(Index vertex) const { return m_positions[vertex]; }

private:
  const Surface& m_surface;
  Element_marks m_face_marks, m_vertex_marks;
  std::vector<Index> m_positions; // by vertex
  std::vector<Index> m_faces;
  std::vector<Double_3> m_points;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SET_H
