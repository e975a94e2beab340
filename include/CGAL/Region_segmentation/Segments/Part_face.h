// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_PART_FACE_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_PART_FACE_H

#include <CGAL/Region_segmentation/Segments/Fitted_surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// A neighbor of a face of a machine part.
struct Part_face_neighbor
{
  std::size_t face;
  double length;  ///< of the border between them
  bool is_smooth; ///< whether their surfaces meet smoothly along most of it
};

/// \ingroup PkgRegionSegmentationSegments
/// A face of a machine part. Lengths and areas are in units of the mesh.
///
/// \tparam Kernel a model of `Kernel`: that of the points of the mesh, see `find_part_faces()`
template <typename Kernel>
struct Part_face
{
  Fitted_surface<Kernel> surface;
  Face_role role = Face_role::NONE;
  double area = 0; ///< of its facets
  /// The first face on the same surface, and the first one with the same axis; itself if no earlier
  /// one is.
  std::size_t first_on_surface = 0, first_on_axis = 0;
  std::vector<Part_face_neighbor> neighbors; ///< by face
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_PART_FACE_H
