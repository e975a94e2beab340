// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_LINK_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_LINK_H

#include <CGAL/Region_segmentation/Surface.h>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// An adjacency of faces of different components.
struct Link
{
  Surface::Index lower, higher; ///< faces
  double length;                ///< of contact; 0 for a gap

  friend bool operator<(const Link& a, const Link& b)
  {
    return a.higher != b.higher ? a.higher < b.higher : a.lower < b.lower;
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_LINK_H
