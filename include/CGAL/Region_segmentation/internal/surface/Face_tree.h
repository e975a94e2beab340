// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FACE_TREE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FACE_TREE_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/Box_tree.h>
#include <CGAL/Region_segmentation/internal/surface/distances.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The faces of a surface, divided into triangles from their first corner, and a tree of their
/// boxes.
class Face_tree
{
public:
  using Index = Surface::Index;

  explicit Face_tree(const Surface& surface)
    : m_surface(surface)
    , m_parts(parts(surface))
    , m_tree(m_parts.size(), [&](Index item) { return box_of(triangle(m_parts[item])); })
  {}

  const Box_tree& boxes() const { return m_tree; }

  /// Of a leaf.
  Index face(Index leaf) const { return m_parts[m_tree.item(leaf)].face; }
  Triangle triangle(Index leaf) const { return triangle(m_parts[m_tree.item(leaf)]); }

private:
  struct Part
  {
    Index face, second_corner;
  };

  static std::vector<Part> parts(const Surface& surface)
  {
    std::vector<Part> result;
    result.reserve(surface.number_of_faces());
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      for (std::size_t i = 1; i == 1 || i + 1 < surface.number_of_corners(f); ++i)
        result.push_back({f, Index(i)});
    return result;
  }

  Triangle triangle(const Part& part) const
  {
    const auto point = [&](std::size_t i) {
      const std::size_t last = m_surface.number_of_corners(part.face) - 1;
      return m_surface.point(m_surface.corner(part.face, (std::min)(i, last)));
    };
    return {point(0), point(part.second_corner), point(part.second_corner + 1)};
  }

  const Surface& m_surface;
  std::vector<Part> m_parts;
  Box_tree m_tree;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FACE_TREE_H
