// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NEAREST_FACE_FINDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NEAREST_FACE_FINDER_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/Face_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds the nearest face of a surface. A face that does not agree counts as farther by a twentieth
/// of the square root of the area: so the other side of a thin wall is not taken, but any face is
/// if none near agrees.
///
/// O(log F) in practice for a point, after O(F log F).
class Nearest_face_finder
{
public:
  using Index = Surface::Index;

  /// \pre there is a face
  explicit Nearest_face_finder(const Surface& surface)
    : m_tree(surface)
    , m_disagreement(0.05 * surface.length_unit())
  {}

  /// Of several the lowest. `p` is in the unit of the surface.
  template <typename Agrees>
  Index find(const Double_3& p, const Agrees& agrees) const
  {
    std::pair<double, Index> nearest(std::numeric_limits<double>::infinity(), 0);
    double bound = nearest.first; // a little above its square
    const Box_tree& boxes = m_tree.boxes();
    boxes.search(
      [&, at = box_of(std::array{p})](Index node) { return squared_gap(boxes.box(node), at); },
      bound,
      [&](Index leaf) {
        const Index face = m_tree.face(leaf);
        const double distance = std::sqrt(squared_distance(p, m_tree.triangle(leaf)));
        nearest = (std::min)(nearest,
                             std::make_pair(distance + (agrees(face) ? 0 : m_disagreement), face));
        bound = 1.000001 * nearest.first * nearest.first + (std::numeric_limits<double>::min)();
      });
    return nearest.second;
  }

private:
  const Face_tree m_tree;
  const double m_disagreement;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_NEAREST_FACE_FINDER_H
