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
#include <set>

namespace mesh_to_step {

namespace {

gp_Dir axis_of_sphere(const gp_Pnt& center, double radius, const Points& points,
                      const std::vector<Points>& loops)
{
  gp_Vec mean(0, 0, 0), area(0, 0, 0);
  for (const gp_Pnt& p : points)
    mean += gp_Vec(center, p) / double(points.size());
  if (mean.Magnitude() > 0.6 * radius) // less than a half
    return seam_direction(mean);
  if (!loops.empty())
    for (std::size_t i = 0; i < loops[0].size(); ++i)
      area += gp_Vec(center, loops[0][i]) ^ gp_Vec(center, loops[0][(i + 1) % loops[0].size()]);
  return area.Magnitude() > 0 ? gp_Dir(area) : gp_Dir(0, 0, 1);
}

/// The angle around the axis, from the seam direction on.
class Angle
{
public:
  explicit Angle(const gp_Ax3& frame)
    : m_frame(frame)
  {}

  double operator()(const gp_Pnt& p) const
  {
    const gp_Vec d(m_frame.Location(), p);
    return std::atan2(d.Dot(m_frame.YDirection()), d.Dot(m_frame.XDirection()));
  }

  bool winds(const Points& loop) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      sum += std::remainder((*this)(loop[(i + 1) % loop.size()]) - (*this)(loop[i]), turn);
    return std::fabs(sum) > M_PI;
  }

  double middle_of_largest_gap(const Points& points) const
  {
    std::set<double> angles;
    for (const gp_Pnt& p : points)
      angles.insert((*this)(p));
    double before = *angles.rbegin() - turn, largest = 0, result = 0;
    for (const double angle : angles) {
      if (angle - before > largest) {
        largest = angle - before;
        result = (angle + before) / 2;
      }
      before = angle;
    }
    return result;
  }

private:
  gp_Ax3 m_frame;
};

} // namespace

gp_Dir seam_direction(const gp_Dir& axis)
{
  const gp_Vec any(0.3184, 0.5291, 0.7866), n(axis);
  const gp_Vec across = any - any.Dot(n) * n;
  return across.Magnitude() > 0.1 ? gp_Dir(across) : gp_Dir(gp_Vec(0.6, -0.8, 0.1) ^ n);
}

Handle(Geom_Surface)
  simple_surface(const Fitted_surface& s, const Points& points, const std::vector<Points>& loops)
{
  const gp_Pnt location = point_of(s.point);
  const gp_Dir axis = s.kind == RS::Surface_kind::SPHERE
                        ? axis_of_sphere(location, s.radius, points, loops)
                        : gp_Dir(s.direction.x(), s.direction.y(), s.direction.z());
  gp_Ax3 frame(location, axis, seam_direction(axis));
  const Angle angle(frame);
  if (!loops.empty() && std::none_of(loops.begin(), loops.end(),
                                     [&](const Points& loop) { return angle.winds(loop); }))
    frame.Rotate(frame.Axis(), angle.middle_of_largest_gap(points));
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
