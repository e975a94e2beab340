// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_SEPARATE_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_SEPARATE_COMPONENTS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/faces/Face_search.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Makes each connected component of a label a face of its own, and those of what was not found
/// freeform faces, which end where the mesh does not go on smoothly.
inline void separate_components(Face_search& search, const Execution& execution)
{
  const Surface& surface = search.surface;
  const Partition components = label_components(
    surface,
    [&](std::size_t a) {
      const Surface::Index label = search.labels[surface.lower_face(a)];
      return label == search.labels[surface.higher_face(a)] &&
             !surface.has_flag(a, Surface::LINK | Surface::CONSTRAINED) &&
             (label != Face_search::none || search.neighbors.may_be_smooth(a));
    },
    execution);
  std::vector<Fitted_surface<>> surfaces(components.number_of_parts());
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f)
    if (search.is_found(f))
      surfaces[components[f]] = search.surface_of(f);
  search.labels.assign(components.begin(), components.end());
  search.surfaces = std::move(surfaces);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_SEPARATE_COMPONENTS_H
