// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_PATCH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_PATCH_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/faces/Face_neighbors.h>
#include <CGAL/Region_segmentation/internal/faces/Face_set.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Some faces around a face, connected by edges, and the points of their vertices.
class Patch : private Face_set
{
public:
  using Face_set::faces;
  using Face_set::points;

  Patch(const Surface& surface, const Face_neighbors& neighbors)
    : Face_set(surface)
    , m_neighbors(neighbors)
  {}

  /// Collects faces in breadth first order from `seed`, across `may_cross(neighbor)`, until they
  /// have `wanted` vertices.
  template <typename MayCross>
  void collect(Surface::Index seed, std::size_t wanted, const MayCross& may_cross)
  {
    clear();
    add(seed);
    for (std::size_t next = 0; next < faces().size() && points().size() < wanted; ++next)
      for (const Face_neighbors::Neighbor& n : m_neighbors[faces()[next]])
        if (!has(n.face) && may_cross(n))
          add(n.face);
  }

private:
  const Face_neighbors& m_neighbors;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_PATCH_H
