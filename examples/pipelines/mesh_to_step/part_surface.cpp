// SPDX-License-Identifier: GPL-3.0-or-later

#include "part_surface.h"

#include <Eigen/Dense>
#include <GeomPlate_BuildPlateSurface.hxx>
#include <GeomPlate_MakeApprox.hxx>
#include <GeomPlate_PointConstraint.hxx>
#include <GeomPlate_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Standard_Failure.hxx>
#include <gp_Ax3.hxx>

#include <algorithm>
#include <cmath>

namespace mesh_to_step {

gp_Dir seam_direction(const gp_Dir& axis)
{
  const gp_Vec any(0.3184, 0.5291, 0.7866), n(axis);
  const gp_Vec across = any - any.Dot(n) * n;
  return across.Magnitude() > 0.1 ? gp_Dir(across) : gp_Dir(gp_Vec(0.6, -0.8, 0.1) ^ n);
}

Handle(Geom_Surface) simple_surface(const Fitted_surface& s)
{
  const gp_Dir axis(s.direction.x(), s.direction.y(), s.direction.z());
  const gp_Ax3 frame(point_of(s.point), axis, seam_direction(axis));
  switch (s.kind) {
  case RS::Surface_kind::CYLINDER:
    return new Geom_CylindricalSurface(frame, s.radius);
  case RS::Surface_kind::CONE:
    return new Geom_ConicalSurface(frame, s.angle, s.radius);
  case RS::Surface_kind::SPHERE:
    return new Geom_SphericalSurface(frame, s.radius);
  case RS::Surface_kind::TORUS:
    return new Geom_ToroidalSurface(frame, s.radius, s.minor_radius);
  default:
    return new Geom_Plane(frame);
  }
}

Handle(Geom_Surface) freeform_surface(const Points& points, double tolerance)
try {
  constexpr std::size_t most_points = 250; // the time is as their third power
  constexpr int degree = 3, most_patches = 8, highest_degree = 8;
  GeomPlate_BuildPlateSurface plate(degree);
  const std::size_t step = points.size() / most_points + 1;
  for (std::size_t i = 0; i < points.size(); i += step)
    plate.Add(new GeomPlate_PointConstraint(points[i], 0));
  plate.Perform();
  if (!plate.IsDone())
    return nullptr;
  const GeomPlate_MakeApprox approximation(plate.Surface(), tolerance / 10, most_patches,
                                           highest_degree, tolerance / 10, -1);
  const Handle(Geom_Surface) result(approximation.Surface());
  const Surfaces surfaces{new ShapeAnalysis_Surface(result)};
  for (const gp_Pnt& p : points)
    if (distance(surfaces, p) > tolerance)
      return nullptr;
  return result;
} catch (const Standard_Failure&) { // points on a line, or all around a part
  return nullptr;
}

Foot foot(const Handle(ShapeAnalysis_Surface) & surface, const gp_Pnt& p)
{
  const gp_Pnt2d uv = surface->ValueOfUV(p, 1e-9);
  Foot result;
  gp_Vec by_u, by_v;
  surface->Surface()->D1(uv.X(), uv.Y(), result.point, by_u, by_v);
  result.normal = by_u ^ by_v;
  if (const double length = result.normal.Magnitude(); length > 0)
    result.normal /= length;
  return result;
}

double distance(const Surfaces& surfaces, const gp_Pnt& p)
{
  double result = 0;
  for (const auto& surface : surfaces)
    result = (std::max)(result, foot(surface, p).point.Distance(p));
  return result;
}

gp_Pnt nearest_point(const Surfaces& surfaces, gp_Pnt p)
{
  constexpr double least_sine = 0.03; // of the angle between surfaces that are not tangent
  const auto n = Eigen::Index(surfaces.size());
  if (n == 1)
    return foot(surfaces[0], p).point;
  for (int step = 0; step < 10 && n > 0; ++step) {
    Eigen::MatrixX3d normals(n, 3);
    Eigen::VectorXd distances(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Foot f = foot(surfaces[std::size_t(i)], p);
      normals.row(i) << f.normal.X(), f.normal.Y(), f.normal.Z();
      distances[i] = gp_Vec(p, f.point).Dot(f.normal);
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixX3d> solver(n, 3);
    solver.setThreshold(least_sine);
    const Eigen::Vector3d move = solver.compute(normals).solve(distances);
    p.Translate({move.x(), move.y(), move.z()});
    if (distances.cwiseAbs().maxCoeff() <= 1e-14 * (1 + p.XYZ().Modulus()))
      break;
  }
  return p;
}

} // namespace mesh_to_step
