// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_FIND_SURFACE_FACES_H
#define CGAL_REGION_SEGMENTATION_FIND_SURFACE_FACES_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/faces/Face_finder.h>

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

inline Surface_faces find_surface_faces(const Surface& surface, const Part_options& options = Part_options())
{
  internal::Face_finder finder(surface, options);
  finder.find();
  Surface_faces result;
  result.partition = Partition::from_labels(finder.labels());
  result.surfaces.resize(result.partition.number_of_parts());
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    result.surfaces[result.partition[f]] = finder.surface_of_label(finder.labels()[f]);
  result.tolerance = finder.tolerance();
  return result;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_FIND_SURFACE_FACES_H
