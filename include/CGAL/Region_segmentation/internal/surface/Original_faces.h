// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIGINAL_FACES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIGINAL_FACES_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/Covered_faces.h>
#include <CGAL/Region_segmentation/internal/surface/find_doubled_faces.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Which faces of a surface are one.
struct Original_faces
{
  using Index = Surface::Index;

  /// By face: the one that it is given twice with, or that it lies on, or else itself.
  std::vector<Index> of;
  /// Adjacencies that the surface without other faces does not have; empty: none.
  std::vector<bool> is_left_out;

  explicit Original_faces(const Surface& surface)
    : of(surface.number_of_faces())
  {
    std::iota(of.begin(), of.end(), Index(0));
    bool has_contacts = false;
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
      const Index lower = surface.lower_face(a), higher = surface.higher_face(a);
      if (surface.has_flag(a, Surface::JOINING) && surface.is_degenerate(higher) &&
          are_equal_faces(surface, lower, higher))
        of[higher] = lower;
      has_contacts = has_contacts || (surface.has_flag(a, Surface::LINK) && surface.length(a) > 0);
    }
    if (!has_contacts)
      return;
    const Covered_faces covered(surface, of);
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
      is_left_out.push_back(covered.is_left_out(a, of));
  }

  bool is_original(std::size_t f) const { return of[f] == f; }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIGINAL_FACES_H
