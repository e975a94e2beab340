// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_PART_FACE_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_PART_FACE_H

#include <CGAL/Region_segmentation/Segments/Fitted_surface.h>

#include <CGAL/Origin.h>

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
/// A face of a machine part with its surface, in units of the mesh: see `Fitted_surface` for the
/// meaning of its members.
///
/// \tparam Kernel a model of `Kernel`: that of the points of the mesh, see `find_part_faces()`
template <typename Kernel>
struct Part_face
{
  Surface_kind kind = Surface_kind::FREEFORM;
  Face_role role = Face_role::NONE;
  typename Kernel::Point_3 point = CGAL::ORIGIN;
  typename Kernel::Vector_3 direction = CGAL::NULL_VECTOR;
  double radius = 0, minor_radius = 0, angle = 0; ///< the angle in radians
  int side = 1;
  double deviation = 0, lowest = 0, highest = 0;

  double area = 0; ///< of its facets
  /// The first face on the same surface, and the first one with the same axis; itself if no earlier
  /// one is.
  std::size_t first_on_surface = 0, first_on_axis = 0;
  std::vector<Part_face_neighbor> neighbors; ///< by face
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_PART_FACE_H
