// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_curve.h"

#include <ElCLib.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <gce_MakeCirc.hxx>
#include <gp_Ax1.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_Lin.hxx>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace mesh_to_step {

namespace {

constexpr double turn = 2 * M_PI;

Handle(Geom_ElementarySurface) elementary(const Handle(ShapeAnalysis_Surface) & surface)
{
  return Handle(Geom_ElementarySurface)::DownCast(surface->Surface());
}

/// The axis, or its opposite, around which the points turn counterclockwise.
gp_Ax1 along_turn(const gp_Ax1& axis, const Points& points)
{
  gp_Vec area(0, 0, 0);
  for (std::size_t i = 1; i < points.size(); ++i)
    area += gp_Vec(axis.Location(), points[i - 1]) ^ gp_Vec(axis.Location(), points[i]);
  return area.Dot(gp_Vec(axis.Direction())) < 0 ? axis.Reversed() : axis;
}

/// A circle or an ellipse from the first point to the last one.
template <typename Curve, typename Conic>
Border_curve border_curve(const Conic& conic, const Border& border)
{
  Border_curve result{{new Curve(conic), 0, turn}, {}};
  for (const gp_Pnt& p : border.points) {
    double t = ElCLib::Parameter(conic, p);
    if (!result.parameters.empty() && t <= result.parameters.back())
      t += turn;
    result.parameters.push_back(t);
  }
  if (!border.is_closed) {
    result.piece.first = result.parameters.front();
    result.piece.last = result.parameters.back();
  }
  return result;
}

std::optional<Border_curve> circle_around(gp_Ax1 axis, const Border& border)
{
  axis = along_turn(axis, border.points);
  const gp_Vec along(axis.Direction()), d(axis.Location(), border.points.front());
  const gp_Pnt center = axis.Location().Translated(d.Dot(along) * along);
  const double radius = center.Distance(border.points.front());
  if (!(radius > 1e-9 * (1 + d.Magnitude())))
    return std::nullopt;
  const gp_Ax2 frame(center, axis.Direction(), seam_direction(axis.Direction()));
  return border_curve<Geom_Circle>(gp_Circ(frame, radius), border);
}

std::optional<Border_curve> circle_through(const Border& border)
{
  const Points& points = border.points;
  const std::size_t n = points.size();
  if (n < 3)
    return std::nullopt;
  const gce_MakeCirc circle(points[0], points[n / 3], points[border.is_closed ? 2 * n / 3 : n - 1]);
  if (!circle.IsDone())
    return std::nullopt;
  return circle_around(circle.Value().Axis(), border);
}

/// The intersection of a plane and a cylinder.
std::optional<Border_curve> ellipse(const Handle(Geom_ElementarySurface) & a,
                                    const Handle(Geom_ElementarySurface) & b, const Border& border)
{
  const auto plane = Handle(Geom_Plane)::DownCast(a);
  const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(b);
  if (plane.IsNull() || cylinder.IsNull())
    return std::nullopt;
  const gp_Vec n(plane->Axis().Direction()), d(cylinder->Axis().Direction());
  const double cosine = n.Dot(d), radius = cylinder->Radius();
  const gp_Vec across = d - cosine * n;
  if (std::fabs(cosine) < 1e-3 || across.Magnitude() < 1e-3)
    return std::nullopt;
  const double t = gp_Vec(cylinder->Location(), plane->Location()).Dot(n) / cosine;
  const gp_Pnt center = cylinder->Location().Translated(t * d);
  const gp_Ax1 axis = along_turn(gp_Ax1(center, n), border.points);
  const gp_Elips conic(gp_Ax2(center, axis.Direction(), across), radius / std::fabs(cosine),
                       radius);
  return border_curve<Geom_Ellipse>(conic, border);
}

std::optional<Border_curve> line(const Points& points)
{
  const double length = points.front().Distance(points.back());
  if (!(length > 0))
    return std::nullopt;
  const gp_Lin line(points.front(), gp_Vec(points.front(), points.back()));
  Border_curve result{{new Geom_Line(line), 0, length}, {}};
  for (const gp_Pnt& p : points)
    result.parameters.push_back(ElCLib::Parameter(line, p));
  return result;
}

/// Whether the curve goes along the points, and along the surfaces as well as the points are on
/// them.
bool fits(const Border_curve& curve, const Points& points, const Surfaces& surfaces,
          double tolerance)
{
  const std::vector<double>& t = curve.parameters;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (curve.piece.curve->Value(t[i]).Distance(points[i]) > tolerance ||
        (i > 0 && t[i] <= t[i - 1]))
      return false;
  constexpr int samples = 16;
  constexpr double share = 0.1;
  double of_points = share * tolerance;
  for (const gp_Pnt& p : points)
    of_points = (std::max)(of_points, distance(surfaces, p));
  return gap(curve.piece, surfaces, samples) <= 2 * of_points;
}

/// The B-spline through the points, whose parameters are lengths along the polyline.
Border_curve interpolation(const Border& border)
{
  const Points& points = border.points;
  Border_curve result{{nullptr, 0, 0}, {0}};
  for (std::size_t i = 1; i < points.size(); ++i)
    result.parameters.push_back(result.parameters.back() + points[i - 1].Distance(points[i]));
  const int n = int(points.size());
  const Handle(TColgp_HArray1OfPnt) array = new TColgp_HArray1OfPnt(1, n - border.is_closed);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, n);
  for (int i = 1; i <= n; ++i) {
    parameters->SetValue(i, result.parameters[std::size_t(i) - 1]);
    if (i <= array->Length())
      array->SetValue(i, points[std::size_t(i) - 1]);
  }
  GeomAPI_Interpolate interpolate(array, parameters, border.is_closed, 1e-12);
  interpolate.Perform();
  result.piece = {Handle(Geom_Curve)(interpolate.Curve()), 0, result.parameters.back()};
  return result;
}

/// A curve through the points, by one through more points of it, which are moved to the surfaces.
Border_curve curve_on_surfaces(const Border& border, const Surfaces& surfaces,
                               std::size_t divisions)
{
  const Points& points = border.points;
  const Border_curve rough = interpolation(border);
  Points dense;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    dense.push_back(points[i]);
    for (std::size_t j = 1; j < divisions; ++j) {
      const double share = double(j) / double(divisions);
      dense.push_back(
        nearest_point(surfaces, rough.piece.curve->Value((1 - share) * rough.parameters[i] +
                                                         share * rough.parameters[i + 1])));
    }
  }
  dense.push_back(points.back());
  Border_curve fine = interpolation({dense, border.is_closed});
  for (std::size_t i = 0; i < points.size(); ++i)
    fine.parameters[i] = fine.parameters[divisions * i];
  fine.parameters.resize(points.size());
  return fine;
}

/// The same of as few points as are enough.
Border_curve curve_on_surfaces(const Border& border, const Surfaces& surfaces, double tolerance)
{
  constexpr std::size_t fewest = 4, most = 32;
  for (std::size_t divisions = fewest;; divisions *= 2) {
    const Border_curve result = curve_on_surfaces(border, surfaces, divisions);
    const int samples = int(3 * divisions * border.points.size());
    if (divisions == most || gap(result.piece, surfaces, samples) <= tolerance)
      return result;
  }
}

} // namespace

double gap(const Curve_piece& piece, const Surfaces& surfaces, int samples)
{
  double result = 0;
  for (int i = 0; i <= samples; ++i)
    result = (std::max)(result, distance(surfaces, piece.point(double(i) / samples)));
  return result;
}

Border_curve make_curve(const Border& border, const Surfaces& surfaces, double tolerance)
{
  constexpr double curve_share = 0.1;
  std::vector<std::optional<Border_curve>> candidates{line(border.points)};
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const auto a = elementary(surfaces[i]), b = elementary(surfaces[surfaces.size() - 1 - i]);
    candidates.push_back(circle_around(a->Axis(), border));
    candidates.push_back(circle_around(gp_Ax1(a->Location(), b->Axis().Direction()), border));
    if (a->Location().Distance(b->Location()) > tolerance)
      candidates.push_back(
        circle_around(gp_Ax1(a->Location(), gp_Vec(a->Location(), b->Location())), border));
    candidates.push_back(ellipse(a, b, border));
  }
  candidates.push_back(circle_through(border));
  for (const auto& candidate : candidates)
    if (candidate && fits(*candidate, border.points, surfaces, tolerance))
      return *candidate;
  return curve_on_surfaces(border, surfaces, curve_share * tolerance);
}

} // namespace mesh_to_step
