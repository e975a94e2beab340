// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_MEASURES_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_MEASURES_H

#include "part_surface.h"

#include <Geom_Curve.hxx>

#include <array>

namespace mesh_to_step {

/// A curve from one parameter to another one.
struct Curve_piece
{
  Handle(Geom_Curve) curve;
  double first = 0, last = 0;

  gp_Pnt point(double share) const { return curve->Value(first + share * (last - first)); }
};

/// The area of a surface and the volume between it and the origin.
struct Measures
{
  double area = 0, volume = 0;
};

/// Those of the piece of a surface that a triangle stands for: of smaller triangles with corners on
/// the surface, extrapolated to infinitely small ones.
///
/// \param surface one, or none of a freeform face
/// \param sides the curve from corner i to the next one, on the border of a face; null inside
Measures measures_on_surface(const std::array<gp_Pnt, 3>& corners, const Surfaces& surface,
                             const std::array<Curve_piece, 3>& sides);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_MEASURES_H
