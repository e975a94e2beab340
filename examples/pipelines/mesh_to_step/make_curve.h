// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_MAKE_CURVE_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_MAKE_CURVE_H

#include "measures.h"
#include "part_surface.h"

namespace mesh_to_step {

/// The curve along a border of two faces.
struct Border_curve
{
  Curve_piece piece;              ///< from its start to its end
  std::vector<double> parameters; ///< of the points of the border
};

/// The line, circle or ellipse that both surfaces have in common and that goes through the points,
/// within the tolerance; else a B-spline through points on the surfaces.
///
/// \param points of the border, from its start to its end, which are equal if it is closed; a full
///        circle begins in the seam direction of its axis
/// \param surfaces those of the two faces that are not freeform
Border_curve make_curve(const Points& points, const Surfaces& surfaces, double tolerance);

/// The largest distance to a surface of points of the curve: of samples + 1 ones.
double gap(const Curve_piece& piece, const Surfaces& surfaces, int samples);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_MAKE_CURVE_H
