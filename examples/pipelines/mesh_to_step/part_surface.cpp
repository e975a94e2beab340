// SPDX-License-Identifier: GPL-3.0-or-later

#include "part_surface.h"

#include <Eigen/Dense>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <gp_Ax3.hxx>
#include <gp_XY.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace mesh_to_step {

namespace {

/// Projects to the part of a B-spline surface where its face is. (OpenCASCADE's projection to
/// surfaces of many spans misses the nearest point.)
class Freeform_projector : public ShapeAnalysis_Surface
{
public:
  Freeform_projector(const Handle(Geom_Surface) & surface, std::vector<Surface_point> points)
    : ShapeAnalysis_Surface(surface)
    , m_points(std::move(points))
  {}

  gp_Pnt2d nearest(const gp_Pnt& p) const
  {
    constexpr std::size_t most_starts = 4;
    const auto is_nearer = [&](const Surface_point& a, const Surface_point& b) {
      return p.SquareDistance(a.point) < p.SquareDistance(b.point);
    };
    std::vector<Surface_point> found((std::min)(most_starts, m_points.size()));
    std::partial_sort_copy(m_points.begin(), m_points.end(), found.begin(), found.end(), is_nearer);
    for (Surface_point& start : found)
      start = descend(*Surface(), start, p);
    return std::min_element(found.begin(), found.end(), is_nearer)->parameters;
  }

private:
  std::vector<Surface_point> m_points;
};

} // namespace

Handle(ShapeAnalysis_Surface)
  projector(const Handle(Geom_Surface) & surface, std::vector<Surface_point> points)
{
  if (points.empty() || surface->IsKind(STANDARD_TYPE(Geom_ElementarySurface)))
    return new ShapeAnalysis_Surface(surface);
  return new Freeform_projector(surface, std::move(points));
}

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

gp_Pnt2d parameters_of_foot(const Handle(ShapeAnalysis_Surface) & surface, const gp_Pnt& p)
{
  const auto* const freeform = dynamic_cast<const Freeform_projector*>(surface.get());
  return freeform ? freeform->nearest(p) : surface->ValueOfUV(p, 1e-9);
}

Foot foot(const Handle(ShapeAnalysis_Surface) & surface, const gp_Pnt& p)
{
  const gp_Pnt2d uv = parameters_of_foot(surface, p);
  Foot result;
  gp_Vec by_u, by_v;
  surface->Surface()->D1(uv.X(), uv.Y(), result.point, by_u, by_v);
  result.normal = by_u ^ by_v;
  if (const double length = result.normal.Magnitude(); length > 0)
    result.normal /= length;
  return result;
}

Surface_point descend(const Geom_Surface& surface, Surface_point from, const gp_Pnt& p)
{
  constexpr int steps = 12;
  double least = std::numeric_limits<double>::infinity();
  std::array<double, 4> bounds;
  surface.Bounds(bounds[0], bounds[1], bounds[2], bounds[3]);
  Surface_point next = from;
  gp_XY move;
  for (int step = 0; step < steps; ++step) {
    gp_Vec by_u, by_v;
    surface.D1(next.parameters.X(), next.parameters.Y(), next.point, by_u, by_v);
    const gp_Vec d(next.point, p);
    if (d.SquareMagnitude() < least) {
      least = d.SquareMagnitude();
      from = next;
      const double a = by_u * by_u, b = by_u * by_v, c = by_v * by_v, determinant = a * c - b * b;
      if (!(determinant > 1e-12 * a * c))
        break; // no normal
      move = gp_XY(c * (d * by_u) - b * (d * by_v), a * (d * by_v) - b * (d * by_u)) / determinant;
    } else
      move /= 2;
    next.parameters = from.parameters.XY() + move;
    next.parameters = {std::clamp(next.parameters.X(), bounds[0], bounds[1]),
                       std::clamp(next.parameters.Y(), bounds[2], bounds[3])};
  }
  return from;
}

double distance(const Surfaces& surfaces, const gp_Pnt& p)
{
  double result = 0;
  for (const auto& surface : surfaces)
    result = (std::max)(result, foot(surface, p).point.Distance(p));
  return result;
}

namespace {

gp_Pnt location(const Handle(ShapeAnalysis_Surface) & surface)
{
  return Handle(Geom_ElementarySurface)::DownCast(surface->Surface())->Location();
}

/// The point of the spine of a surface next to `p`, and its distance from the surface; none of
/// surfaces without a spine.
std::optional<std::pair<gp_Pnt, double>> spine_point(const Handle(Geom_Surface) & surface,
                                                     const gp_Pnt& p)
{
  if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull())
    return std::make_pair(sphere->Location(), sphere->Radius());
  const auto elementary = Handle(Geom_ElementarySurface)::DownCast(surface);
  if (elementary.IsNull())
    return std::nullopt;
  const gp_Vec axis(elementary->Axis().Direction()), d(elementary->Location(), p);
  const gp_Vec along = d.Dot(axis) * axis;
  if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull())
    return std::make_pair(cylinder->Location().Translated(along), cylinder->Radius());
  const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface);
  if (const gp_Vec outward = d - along; !torus.IsNull() && outward.Magnitude() > 0)
    return std::make_pair(torus->Location().Translated(torus->MajorRadius() * outward.Normalized()),
                          torus->MinorRadius());
  return std::nullopt;
}

/// The vector from `p` to the points next to it in which two surfaces touch, if they do.
std::optional<gp_Vec> step_to_contact(const Handle(ShapeAnalysis_Surface) & first,
                                      const Handle(ShapeAnalysis_Surface) & second, const gp_Pnt& p)
{
  constexpr double precision = 1e-6, near = 0.02; // of the radius
  const auto of_second = spine_point(second->Surface(), p),
             of_first = spine_point(first->Surface(), p);
  if (!of_second)
    return std::nullopt;
  const auto& [center, radius] = *of_second;
  if (of_first && of_first->first.Distance(center) < near * radius) {
    if (std::fabs(of_first->second - radius) > precision * radius ||
        second->Surface()->IsKind(STANDARD_TYPE(Geom_CylindricalSurface)))
      return std::nullopt;
    const auto touching = spine_point(first->Surface(), location(second));
    return touching ? std::optional<gp_Vec>({of_first->first, touching->first}) : std::nullopt;
  }
  const gp_Pnt contact = foot(first, center).point;
  if (std::fabs(contact.Distance(center) - radius) > precision * radius ||
      contact.Distance(p) > near * radius)
    return std::nullopt;
  return gp_Vec(p, contact);
}

} // namespace

gp_Pnt nearest_point(const Surfaces& surfaces, gp_Pnt p)
{
  constexpr double least_sine = 0.03; // of the angle between surfaces that are not tangent
  constexpr int most_steps = 10;
  if (surfaces.size() == 1)
    return foot(surfaces[0], p).point;
  for (int step = 0; step < most_steps && !surfaces.empty(); ++step) {
    const double rounding = 1e-14 * (1 + p.XYZ().Modulus());
    std::vector<std::pair<gp_Vec, double>> moves; // directions of length 1, and how far to go
    for (const auto& surface : surfaces) {
      const Foot f = foot(surface, p);
      moves.emplace_back(f.normal, gp_Vec(p, f.point).Dot(f.normal));
      for (const auto& other : surfaces)
        if (const auto contact = step_to_contact(surface, other, p); contact && surface != other) {
          const gp_Vec beside = *contact - contact->Dot(f.normal) * f.normal;
          if (beside.Magnitude() > rounding)
            moves.emplace_back(beside.Normalized(), beside.Magnitude());
        }
    }
    Eigen::MatrixX3d directions(moves.size(), 3);
    Eigen::VectorXd distances(moves.size());
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const auto& [direction, length] = moves[i];
      directions.row(Eigen::Index(i)) << direction.X(), direction.Y(), direction.Z();
      distances[Eigen::Index(i)] = length;
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixX3d> solver(directions.rows(), 3);
    solver.setThreshold(least_sine);
    const Eigen::Vector3d move = solver.compute(directions).solve(distances);
    p.Translate({move.x(), move.y(), move.z()});
    if (distances.cwiseAbs().maxCoeff() <= rounding)
      break;
  }
  return p;
}

} // namespace mesh_to_step
