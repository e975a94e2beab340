// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FIND_SMALL_PLANES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FIND_SMALL_PLANES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/faces/Face_search.h>

#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds plane faces of few vertices: those whose border is mostly not smooth, or meets faces that
/// are found.
inline void find_small_planes(Face_search& search, const Execution& execution)
{
  constexpr std::size_t few_points = 8;
  search.clear_tried();
  const std::vector<Surface::Index> seeds = search.seeds();
  Step_counter progress(execution, seeds.size());
  for (const Surface::Index seed : seeds) {
    progress.advance();
    if (search.is_found(seed) || search.is_tried[seed])
      continue;
    Fitted_surface<> s = surface_of_kind(Surface_kind::PLANE, search.surface.centroid(seed),
                                         search.surface.normal(seed));
    search.grower.grow(s, {seed}, [&](Surface::Index f) { return !search.is_found(f); });
    const std::vector<Surface::Index>& faces = search.grower.faces();
    if (share_of_smooth_border(search) < (search.grower.points().size() < few_points ? 0.1 : 0.5))
      search.add(s, faces);
    else
      for (const Surface::Index f : faces)
        search.is_tried[f] = 1;
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FIND_SMALL_PLANES_H
