// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_INITIAL_SURFACES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_INITIAL_SURFACES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/internal/part_faces/fit_surface.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The paraboloid that osculates a surface: a point, its normal, principal directions, and the
/// curvatures along them, positive where the surface bends towards the normal. `curvature[0]` is
/// the larger one in absolute value.
struct Osculating_paraboloid
{
  Double_3 point, normal, direction[2];
  double curvature[2];
};

/// Least squares over points around `origin`, which lie on the surface; `normal` is approximate.
/// The curvatures are regularized, so that they are 0 where the points do not tell them.
inline Osculating_paraboloid osculating_paraboloid(const std::vector<Double_3>& points,
                                                   const Double_3& origin, const Double_3& normal)
{
  using Vector = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;
  using Matrix = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;
  const Double_3 u = any_perpendicular(normal), v = cross(normal, u);
  double size = 0;
  for (const Double_3& p : points)
    size = (std::max)(size, norm(p - origin));
  Matrix a = Matrix::Zero();
  Vector b = Vector::Zero();
  for (const Double_3& p : points) {
    const Double_3 d = (1 / size) * (p - origin);
    const double x = dot(d, u), y = dot(d, v), h = dot(d, normal);
    Vector row;
    row << 0.5 * x * x, x * y, 0.5 * y * y, x, y, 1;
    b += h * row;
    a += row * row.transpose();
  }
  for (int i = 0; i < 6; ++i)
    a(i, i) += 1e-7 * double(points.size());
  const Vector c = solve_positive_definite(a, b);

  // The shape operator in an orthonormal frame of the tangent plane at the origin.
  Double_3 n = normal - c[3] * u - c[4] * v;
  const double slope = norm(n);
  n = (1 / slope) * n;
  Double_3 e1 = u + c[3] * normal;
  const double f1 = norm(e1);
  e1 = (1 / f1) * e1;
  const Double_3 e2 = cross(n, e1);
  // e1 and e2 in coordinates x, y.
  const double x1 = dot(e1, u), y1 = dot(e1, v), x2 = dot(e2, u), y2 = dot(e2, v);
  const auto second = [&](double xa, double ya, double xb, double yb) {
    return (c[0] * xa * xb + c[1] * (xa * yb + xb * ya) + c[2] * ya * yb) / (slope * size);
  };
  const double l = second(x1, y1, x1, y1), m = second(x1, y1, x2, y2), k = second(x2, y2, x2, y2);
  const double mean = (l + k) / 2, half = std::sqrt((l - k) * (l - k) / 4 + m * m),
               angle = 0.5 * std::atan2(2 * m, l - k);
  const Double_3 larger = std::cos(angle) * e1 + std::sin(angle) * e2;
  const Double_3 other = cross(n, larger);
  Osculating_paraboloid result{
    origin + (c[5] * size) * normal, n, {larger, other}, {mean + half, mean - half}};
  if (std::fabs(result.curvature[1]) > std::fabs(result.curvature[0])) {
    std::swap(result.curvature[0], result.curvature[1]);
    std::swap(result.direction[0], result.direction[1]);
  }
  return result;
}

inline Fitted_surface<> initial_cylinder(const Osculating_paraboloid& o)
{
  Fitted_surface<> s = surface_of_kind(Surface_kind::CYLINDER,
                                       o.point + (1 / o.curvature[0]) * o.normal, o.direction[1]);
  s.radius = 1 / std::fabs(o.curvature[0]);
  return s;
}

/// The cylinder along `axis` whose section is the circle with the least algebraic distance to the
/// points.
inline Fitted_surface<> cylinder_along(const Double_3& axis, const std::vector<Double_3>& points,
                                       const Double_3& origin)
{
  const Double_3 u = any_perpendicular(axis), v = cross(axis, u);
  Eigen::Matrix<double, 3, 3, Eigen::DontAlign> a = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 1, Eigen::DontAlign> b = Eigen::Vector3d::Zero();
  for (const Double_3& p : points) {
    const double x = dot(p - origin, u), y = dot(p - origin, v);
    const Eigen::Matrix<double, 3, 1, Eigen::DontAlign> row(2 * x, 2 * y, 1);
    a += row * row.transpose();
    b += (x * x + y * y) * row;
  }
  const Eigen::Matrix<double, 3, 1, Eigen::DontAlign> c = solve_positive_definite(a, b);
  Fitted_surface<> s = surface_of_kind(Surface_kind::CYLINDER, origin + c[0] * u + c[1] * v, axis);
  s.radius = std::sqrt((std::max)(0.0, c[2] + c[0] * c[0] + c[1] * c[1]));
  return s;
}

inline Fitted_surface<> initial_sphere(const Osculating_paraboloid& o)
{
  const double k = (o.curvature[0] + o.curvature[1]) / 2;
  Fitted_surface<> s = surface_of_kind(Surface_kind::SPHERE, o.point + (1 / k) * o.normal,
                                       o.normal);
  s.radius = 1 / std::fabs(k);
  return s;
}

/// The axis of a cone meets the normal at the center of curvature; `angle` is that between axis and
/// ruling, of any sign.
inline Fitted_surface<> initial_cone(const Osculating_paraboloid& o, double angle)
{
  const Double_3 axis = std::cos(angle) * o.direction[1] + std::sin(angle) * o.normal;
  const double distance = 1 / o.curvature[0];
  const Double_3 on_axis = o.point + distance * o.normal;
  Fitted_surface<> s = surface_of_kind(Surface_kind::CONE, on_axis, axis);
  const double z = dot(o.point - on_axis, axis);
  s.point = on_axis + z * axis;
  s.radius = norm(o.point - s.point);
  s.angle = distance > 0 ? angle : -angle;
  return s;
}

/// The axis of a torus meets the normal at the center of curvature along the parallel; the circle
/// in the tube, at that along the meridian, which is `direction[meridian]`; `angle` is that between
/// axis and meridian.
inline Fitted_surface<> initial_torus(const Osculating_paraboloid& o, int meridian, double angle)
{
  const double along_parallel = o.curvature[1 - meridian],
               smallest = 0.02 * std::fabs(o.curvature[0]);
  const double parallel = std::fabs(along_parallel) < smallest
                            ? std::copysign(smallest, along_parallel)
                            : along_parallel;
  const Double_3 axis = std::cos(angle) * o.direction[meridian] + std::sin(angle) * o.normal;
  const Double_3 on_axis = o.point + (1 / parallel) * o.normal;
  const Double_3 tube = o.point + (1 / o.curvature[meridian]) * o.normal;
  const double z = dot(tube - on_axis, axis);
  Fitted_surface<> s = surface_of_kind(Surface_kind::TORUS, on_axis + z * axis, axis);
  s.radius = norm(tube - s.point);
  s.minor_radius = 1 / std::fabs(o.curvature[meridian]);
  return s;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_INITIAL_SURFACES_H
