// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_PART_SURFACE_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_PART_SURFACE_H

#include "part_mesh.h"

#include <Geom_Surface.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>
#include <gp_XY.hxx>

#include <optional>
#include <vector>

namespace mesh_to_step {

using Points = std::vector<gp_Pnt>;
/// Surfaces, with what projects points to them.
using Surfaces = std::vector<Handle(ShapeAnalysis_Surface)>;

inline gp_Pnt point_of(const Point& p)
{
  return {p.x(), p.y(), p.z()};
}

/// A direction across an axis, which is the same for the axis and its opposite: there are the seams
/// of surfaces around the axis, and the ends of full circles.
gp_Dir seam_direction(const gp_Dir& axis);

/// A surface that is not freeform, as OpenCASCADE has it.
Handle(Geom_Surface) simple_surface(const Fitted_surface& s);

/// A surface with what projects points to it.
Handle(ShapeAnalysis_Surface) projector(const Handle(Geom_Surface) & surface);

/// The parameters of the point of a surface next to `p`.
gp_Pnt2d parameters_of_foot(const Handle(ShapeAnalysis_Surface) & surface, const gp_Pnt& p);

/// The foot of a point on a surface, and the unit normal there, or zero at an apex.
struct Foot
{
  gp_Pnt point;
  gp_Vec normal;
};

Foot foot(const Handle(ShapeAnalysis_Surface) & surface, const gp_Pnt& p);

/// The step of the parameters towards those of the foot of a point, by Gauss and Newton's method;
/// none where the surface has no normal.
///
/// \param by_u, by_v derivatives of the surface at the parameters
/// \param d the vector from the point there to the other one
std::optional<gp_XY> step_to_foot(const gp_Vec& by_u, const gp_Vec& by_v, const gp_Vec& d);

/// The distance of a point to the farthest of the surfaces.
double distance(const Surfaces& surfaces, const gp_Pnt& p);

/// The point next to `p` that all surfaces have in common, or that is nearest to them, by Newton's
/// method. Where surfaces are tangent, it does not move along them.
gp_Pnt nearest_point(const Surfaces& surfaces, gp_Pnt p);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_PART_SURFACE_H
