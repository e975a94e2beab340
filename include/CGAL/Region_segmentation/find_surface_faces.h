// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_FIND_SURFACE_FACES_H
#define CGAL_REGION_SEGMENTATION_FIND_SURFACE_FACES_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/faces/Face_finder.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// The faces of a machine part: a partition of the faces of its mesh, and the surface of each part.
struct Surface_faces
{
  Partition partition;
  std::vector<Fitted_surface> surfaces;
  double tolerance = 0; ///< that was used, in units of the surface
};

/// \ingroup PkgRegionSegmentationSegments
/// Finds the faces of a machine part, each with its surface. Degenerate faces belong to the face on whose surface their vertices lie.
///
/// Deterministic; independent of scale. Near linear in the number of faces.
inline Surface_faces find_surface_faces(const Surface& surface, const Part_options& options = Part_options())
{
  internal::Face_finder finder(surface, options);
  finder.find();
  Surface_faces result;
  result.partition = Partition::from_labels(finder.labels());
  result.surfaces.resize(result.partition.number_of_parts());
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    result.surfaces[result.partition[f]] = finder.surface_of_label(finder.labels()[f]);
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    Fitted_surface& s = result.surfaces[result.partition[f]];
    for (std::size_t i = 0; s.kind != Surface_kind::FREEFORM && i < surface.number_of_corners(f); ++i)
      s.deviation = (std::max)(s.deviation, std::fabs(internal::signed_distance(s, surface.point(surface.corner(f, i)))));
  }
  result.tolerance = finder.tolerance();
  return result;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_FIND_SURFACE_FACES_H
