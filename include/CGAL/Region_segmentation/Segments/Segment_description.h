// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_SEGMENT_DESCRIPTION_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_SEGMENT_DESCRIPTION_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>

#include <CGAL/Origin.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// A segment that shares edges with another one.
///
/// \tparam Label the value type of the map of segments
template <typename Label>
struct Segment_neighbor
{
  Label segment;        ///< `no_segment` for the faces that have none
  double border_length; ///< the length of the shared edges, in units of the mesh
  /// The mean over the shared edges, weighted by length, of the angle between the two normals: in
  /// radians, in [-pi, pi], positive for convex and negative for concave edges. Edges of degenerate
  /// faces count as flat.
  double mean_signed_deviation;
};

/// \ingroup PkgRegionSegmentationSegments
/// The shape of a segment, and where it is. Lengths, areas and volumes are in units of the mesh.
///
/// \tparam Label the value type of the map of segments
/// \tparam Kernel a model of `Kernel`: that of the points of the mesh, see `describe_segments()`
template <typename Label, typename Kernel>
struct Segment_description
{
  Label segment;
  std::size_t number_of_faces = 0;
  double area = 0; ///< the area of all faces, degenerate ones included

  /// The volume enclosed by the segment and its caps; negative for a cavity. The caps are those of
  /// `close_segments()`, so the volumes of all segments, and of the faces without a segment, add up
  /// to the volume of the mesh; the borders of an open mesh have caps, too. A closed component that
  /// is inside out is read as if it were not, see `make_surface()`.
  double volume = 0;
  /// The part of the volume of the mesh; 0 if that is below 1e-12 of its area to the power of 3/2.
  double volume_share = 0;

  typename Kernel::Point_3 centroid = CGAL::ORIGIN; ///< that of the surface
  /// The principal axes of the surface, of length 1, from the largest to the smallest moment; a
  /// right-handed system. The first two point where their component of largest absolute value is
  /// positive.
  std::array<typename Kernel::Vector_3, 3> axes{};
  std::array<double, 3> extents{}; ///< those of the smallest box along the axes

  /// The length of the edges to other segments and to faces without a segment.
  double border_length = 0;
  double boundary_length = 0; ///< the length of the edges on the border of the mesh
  /// The neighbors in the order of their first faces, `no_segment` last.
  std::vector<Segment_neighbor<Label>> neighbors;

  /// The plane, cylinder, cone or sphere that fits best. The point of a cylinder or cone is next to
  /// the centroid.
  Fitted_surface<Kernel> surface;
  /// The root mean square distances of the corners of the faces, weighted by area, to the best
  /// plane, cylinder, cone and sphere, by `Surface_kind`; infinite where none was found.
  std::array<double, 4> surface_errors{};

  /// The member of `surface_errors` for the kind of `surface`.
  double surface_error() const { return surface_errors[std::size_t(surface.kind)]; }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_SEGMENT_DESCRIPTION_H
