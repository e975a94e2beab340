// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_FITTED_PRIMITIVE_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_FITTED_PRIMITIVE_H

#include <CGAL/Origin.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// The kinds of primitives, from the simplest on.
enum class Primitive_type { PLANE, SPHERE, CYLINDER, CONE };

/// \ingroup PkgRegionSegmentationSegments
/// The primitive that fits a segment best. Lengths are in units of the mesh.
///
/// \tparam Kernel a model of `Kernel`: that of the points of the mesh, see `describe_segments()`
template <typename Kernel>
struct Fitted_primitive
{
  Primitive_type type = Primitive_type::PLANE;

  /// A point of the plane, the center of the sphere, the point of the axis of the cylinder that is
  /// nearest to the centroid of the segment, the apex of the cone.
  typename Kernel::Point_3 point = CGAL::ORIGIN;
  /// Of length 1: the normal of the plane, on the side of those of the faces; the axis of the
  /// cylinder; the axis of the cone, from the apex to the surface. 0 for a sphere.
  typename Kernel::Vector_3 direction = CGAL::NULL_VECTOR;
  double radius = 0;     ///< of the sphere or the cylinder
  double half_angle = 0; ///< of the cone, in radians, in (0, pi/2)

  /// The root mean square distance of the corners of the faces to the primitive, weighted by area.
  double error = 0;
  /// The same for the best primitive of each type, by `Primitive_type`; infinite where none was
  /// found.
  std::array<double, 4> errors{};

  double error_of(Primitive_type t) const { return errors[std::size_t(t)]; }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_FITTED_PRIMITIVE_H
