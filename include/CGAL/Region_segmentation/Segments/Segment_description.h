// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_SEGMENT_DESCRIPTION_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_SEGMENT_DESCRIPTION_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Segments/Fitted_primitive.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// A segment that shares edges with another one.
template <typename Label>
struct Segment_neighbor
{
  Label segment;        ///< `no_segment` for the faces that have none
  double border_length; ///< of the shared edges, in units of the mesh
  /// The mean over the shared edges, weighted by length, of the angle between the two normals: in radians, in [-pi, pi],
  /// positive for convex and negative for concave edges. Edges of degenerate faces count as flat.
  double mean_signed_deviation;
};

/// \ingroup PkgRegionSegmentationSegments
/// The shape of a segment, and where it is. Lengths, areas and volumes are in units of the mesh.
template <typename Label>
struct Segment_description
{
  Label segment;
  std::size_t number_of_faces = 0;
  double area = 0;

  /// The volume enclosed by the segment and a cap on each loop of its border, made of the triangles to the mean of the
  /// points of the loop; negative for a cavity. Where every loop separates two segments, the volumes add up to that of the
  /// surface. A closed surface that is inside out is read as if it were not, see `Flat_mesh`. On an open surface it depends on
  /// the caps of loops along the boundary of the mesh, and is of little use.
  double volume = 0;
  /// The part of the sum of the volumes of all segments; 0 if this sum is not positive.
  double volume_share = 0;

  Double_3 centroid{0, 0, 0}; ///< of the surface
  /// The principal axes of the surface, of length 1, from the largest to the smallest moment; a right-handed system. The
  /// first two point where their component of largest absolute value is positive.
  std::array<Double_3, 3> axes{};
  std::array<double, 3> extents{}; ///< along these axes: of the smallest box that contains the segment

  double border_length = 0;   ///< of the edges to other segments, and to faces without a segment
  double boundary_length = 0; ///< of the edges on the border of the mesh
  std::vector<Segment_neighbor<Label>> neighbors; ///< in the order of their first faces, `no_segment` last

  Fitted_primitive primitive;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_SEGMENT_DESCRIPTION_H
