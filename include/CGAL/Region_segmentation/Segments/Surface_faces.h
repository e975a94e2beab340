// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_SURFACE_FACES_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_SURFACE_FACES_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Segments/Fitted_surface.h>

#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// The faces of a machine part: a partition of the faces of its mesh, and what is known of each
/// part. Their neighbors, and which of these they meet smoothly, are a graph:
/// `build_region_adjacency_graph<Surface_face_region_data, Surface_face_section_data>()`, filled by
/// `annotate_surface_faces()`.
struct Surface_faces
{
  Partition partition;                    ///< of the faces of the mesh
  std::vector<Fitted_surface<>> surfaces; ///< by part, in units of the surface
  std::vector<Face_role> roles;           ///< by part
  double tolerance = 0;                   ///< that was used, in units of the surface
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_SURFACE_FACES_H
