// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SET_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SET_H

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
  {}

  void clear()
  {
    m_faces.clear();
    m_points.clear();
    m_face_marks.clear();
    m_vertex_marks.clear();
    m_area = 0;
  }

  /// \pre the set does not have the face
  void add(Index face)
  {
    m_face_marks.mark(face);
    m_faces.push_back(face);
    m_area += m_surface.area(face);
    for (const Index v : m_surface.corners(face))
      if (m_vertex_marks.mark(v))
        m_points.push_back(m_surface.point(v));
  }

  bool has(Index face) const { return m_face_marks.has(face); }
  const std::vector<Index>& faces() const { return m_faces; }
  /// Of the vertices, each once.
  const std::vector<Double_3>& points() const { return m_points; }
  double area() const { return m_area; }

private:
  const Surface& m_surface;
  Element_marks m_face_marks, m_vertex_marks;
  std::vector<Index> m_faces;
  std::vector<Double_3> m_points;
  double m_area = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SET_H
