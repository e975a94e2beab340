// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NEAREST_FACE_FINDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NEAREST_FACE_FINDER_H

#include <CGAL/Region_segmentation/internal/segments/Mesh_geometry.h>
#include <CGAL/Region_segmentation/internal/surface/Component_tree.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds the nearest face of a mesh. A face whose normal does not agree counts as farther by a
/// twentieth of the square root of the area of the mesh: so the other side of a thin wall is not
/// taken, but any face is if none near has a normal that agrees.
///
/// O(log F) in practice for a point, after O(F).
class Nearest_face_finder
{
public:
  using Index = Surface::Index;

  /// \pre there is a face
  explicit Nearest_face_finder(const Mesh_geometry& geometry)
    : m_geometry(geometry)
    , m_tree(geometry.surface(), all_faces(geometry))
    , m_disagreement(0.05 * geometry.surface().length_unit())
  {}

  /// Of several the lowest. `p` is in the unit of the mesh of the faces. Without a normal (zero)
  /// all agree.
  Index find(const Double_3& p, const Double_3& normal)
  {
    m_point = p;
    m_normal = normal;
    m_cost = std::numeric_limits<double>::infinity();
    m_face = 0;
    search(Component_tree::root());
    return m_face;
  }

private:
  static Partition all_faces(const Mesh_geometry& geometry)
  {
    return Partition(std::vector<Index>(geometry.surface().number_of_faces(), 0), 1);
  }

  double gap(Index node) const
  {
    return squared_gap(m_tree[node].box, box_of(std::array{m_point}));
  }

  /// Depth first, the nearer child first.
  void search(Index node)
  {
    if (m_tree.is_leaf(node)) {
      for (const auto* part = m_tree.begin(node); part != m_tree.end(node); ++part)
        compare(*part);
      return;
    }
    Index nearer = m_tree.children(node), farther = nearer + 1;
    double nearer_gap = gap(nearer), farther_gap = gap(farther);
    if (farther_gap < nearer_gap) {
      std::swap(nearer, farther);
      std::swap(nearer_gap, farther_gap);
    }
    if (nearer_gap <= m_cost * m_cost)
      search(nearer);
    if (farther_gap <= m_cost * m_cost)
      search(farther);
  }

  void compare(const Component_tree::Part& part)
  {
    double cost = std::sqrt(squared_distance(m_point, m_tree.triangle(part)));
    if (squared_norm(m_normal) > 0 && !(dot(m_normal, m_geometry.given_normal(part.face)) > 0))
      cost += m_disagreement;
    if (std::pair(cost, part.face) < std::pair(m_cost, m_face)) {
      m_cost = cost;
      m_face = part.face;
    }
  }

  const Mesh_geometry& m_geometry;
  Component_tree m_tree;
  const double m_disagreement;
  Double_3 m_point, m_normal;
  double m_cost;
  Index m_face;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NEAREST_FACE_FINDER_H
