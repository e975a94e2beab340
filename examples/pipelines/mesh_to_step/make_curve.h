// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_MAKE_CURVE_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_MAKE_CURVE_H

#include "part_surface.h"

#include <Geom_Curve.hxx>

namespace mesh_to_step {

/// A curve from one parameter to another one.
struct Curve_piece
{
  Handle(Geom_Curve) curve;
  double first = 0, last = 0;

  gp_Pnt point(double share) const { return curve->Value(first + share * (last - first)); }
};

/// A border of two faces, from its start to its end.
struct Border
{
  Points points;
  bool is_closed; ///< else the ends are two vertices, which may be at one point
};

/// The curve along a border.
struct Border_curve
{
  Curve_piece piece;              ///< from its start to its end
  std::vector<double> parameters; ///< of the points of the border
};

/// The line, circle or ellipse that both surfaces have in common and that goes through the points,
/// within the tolerance; else a B-spline through points on the surfaces.
/// A closed circle begins in the seam direction of its axis.
///
/// \param surfaces those of the two faces that are not freeform
Border_curve make_curve(const Border& border, const Surfaces& surfaces, double tolerance);

/// The largest distance to a surface of points of the curve: of samples + 1 ones.
double gap(const Curve_piece& piece, const Surfaces& surfaces, int samples);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_MAKE_CURVE_H
