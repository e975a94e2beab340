// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NEAREST_FACE_FINDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NEAREST_FACE_FINDER_H

#include <CGAL/Region_segmentation/internal/segments/Mesh_geometry.h>
#include <CGAL/Region_segmentation/internal/surface/find_nearest_face.h>

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
    Cost_of_face best(std::numeric_limits<double>::infinity(), 0);
    find_nearest_face(
      m_tree, Component_tree::root(), p, [](const auto&) { return true; },
      [&](Index f) {
        const bool agrees = squared_norm(normal) == 0 ||
                            dot(normal, m_geometry.given_normal(f)) > 0;
        return agrees ? 0 : m_disagreement;
      },
      best);
    return best.second;
  }

private:
  static Partition all_faces(const Mesh_geometry& geometry)
  {
    return Partition(std::vector<Index>(geometry.surface().number_of_faces(), 0), 1);
  }

  const Mesh_geometry& m_geometry;
  Component_tree m_tree;
  const double m_disagreement;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NEAREST_FACE_FINDER_H
