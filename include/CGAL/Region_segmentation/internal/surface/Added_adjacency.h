// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ADDED_ADJACENCY_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ADDED_ADJACENCY_H

#include <CGAL/Region_segmentation/Surface.h>

#include <algorithm>
#include <cstdint>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// An adjacency that is added to those across edges.
struct Added_adjacency
{
  Surface::Index lower, higher; ///< faces
  double squared_length;
  std::uint8_t flags;
  Surface::Index side = Surface::none, other_side = Surface::none; ///< of a seam: its corners
  Surface::Index place = Surface::none;                            ///< once it is inserted

  friend bool operator<(const Added_adjacency& a, const Added_adjacency& b)
  {
    return a.higher != b.higher ? a.higher < b.higher : a.lower < b.lower;
  }
};

/// A link between two faces, with the length of contact; 0 for a gap.
inline Added_adjacency link_of(Surface::Index f, Surface::Index g, double length)
{
  return {(std::min)(f, g), (std::max)(f, g), length * length, Surface::LINK};
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ADDED_ADJACENCY_H
