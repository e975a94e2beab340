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

/// A point of a surface, and its parameters.
struct Surface_point
{
  gp_Pnt point;
  gp_Pnt2d parameters;
};

/// A surface with what projects points to it.
///
/// \param points of a freeform face: projections start at the nearest of them, since a B-spline
///        surface may come back to itself beyond its face
Handle(ShapeAnalysis_Surface)
  projector(const Handle(Geom_Surface) & surface, std::vector<Surface_point> points = {});

/// The parameters of the point of a surface next to `p`.
gp_Pnt2d parameters_of_foot(const Handle(ShapeAnalysis_Surface) & surface, const gp_Pnt& p);

/// The foot of a point on a surface, and the unit normal there, or zero at an apex.
struct Foot
{
  gp_Pnt point;
  gp_Vec normal;
};

Foot foot(const Handle(ShapeAnalysis_Surface) & surface, const gp_Pnt& p);

/// Moves a point along a surface to one that is nearest to `p`, by Gauss and Newton's method, with
/// halved steps where the distance grows.
Surface_point descend(const Geom_Surface& surface, Surface_point from, const gp_Pnt& p);

/// The distance of a point to the farthest of the surfaces.
double distance(const Surfaces& surfaces, const gp_Pnt& p);

/// The point next to `p` that all surfaces have in common, or that is nearest to them, by Newton's
/// method. Where surfaces are tangent, it does not move along them.
gp_Pnt nearest_point(const Surfaces& surfaces, gp_Pnt p);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_PART_SURFACE_H
