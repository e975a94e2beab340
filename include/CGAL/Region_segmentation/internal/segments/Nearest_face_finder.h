// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NEAREST_FACE_FINDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NEAREST_FACE_FINDER_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/find_nearest_face.h>

#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds the nearest face of a surface. A face that does not agree counts as farther by a twentieth
/// of the square root of the area: so the other side of a thin wall is not taken, but any face is
/// if none near agrees.
///
/// O(log F) in practice for a point, after O(F).
class Nearest_face_finder
{
public:
  using Index = Surface::Index;

  /// \pre there is a face
  explicit Nearest_face_finder(const Surface& surface)
    : m_tree(surface, Partition(Partition::Numbers(surface.number_of_faces(), 0), 1))
    , m_disagreement(0.05 * surface.length_unit())
  {}

  /// Of several the lowest. `p` is in the unit of the surface.
  template <typename Agrees>
  Index find(const Double_3& p, const Agrees& agrees)
  {
    Cost_of_face best(std::numeric_limits<double>::infinity(), 0);
    find_nearest_face(
      m_tree, Component_tree::root(), p, [](const auto&) { return true; },
      [&](Index f) { return agrees(f) ? 0 : m_disagreement; }, best);
    return best.second;
  }

private:
  Component_tree m_tree;
  const double m_disagreement;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NEAREST_FACE_FINDER_H
