// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_INITIAL_SURFACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_INITIAL_SURFACES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
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

/// The solution of the linear equations with coefficients `row(p)` and right sides `value(p)` at
/// points, in the sense of least squares.
template <int n, typename Row, typename Value>
Eigen::Matrix<double, n, 1, Eigen::DontAlign> least_squares(const std::vector<Double_3>& points,
                                                            const Row& row, const Value& value)
{
  Eigen::Matrix<double, n, n, Eigen::DontAlign> a = Eigen::Matrix<double, n, n>::Zero();
  Eigen::Matrix<double, n, 1, Eigen::DontAlign> b = Eigen::Matrix<double, n, 1>::Zero();
  for (const Double_3& p : points) {
    const std::array<double, std::size_t(n)> r = row(p);
    for (int i = 0; i < n; ++i) {
      b[i] += value(p) * r[std::size_t(i)];
      for (int j = 0; j <= i; ++j)
        a(i, j) += r[std::size_t(i)] * r[std::size_t(j)];
    }
  }
  return solve_positive_definite(a, b);
}

/// The sphere with the least algebraic distance to points. `axis`: that of its parallels, if they
/// are on any
inline Fitted_surface<> sphere_with_axis(const Double_3& axis, const std::vector<Double_3>& points,
                                         const Double_3& origin)
{
  const auto c = least_squares<4>(
    points,
    [&](const Double_3& p) {
      const Double_3 d = p - origin;
      return std::array<double, 4>{2 * d.x, 2 * d.y, 2 * d.z, 1};
    },
    [&](const Double_3& p) { return squared_norm(p - origin); });
  const Double_3 center{c[0], c[1], c[2]};
  Fitted_surface<> s = surface_of_kind(Surface_kind::SPHERE, origin + center, axis);
  s.radius = std::sqrt((std::max)(0.0, c[3] + squared_norm(center)));
  return s;
}

/// The cylinder along `axis` whose section is the circle with the least algebraic distance to
/// points.
inline Fitted_surface<> cylinder_along(const Double_3& axis, const std::vector<Double_3>& points,
                                       const Double_3& origin)
{
  const Double_3 u = any_perpendicular(axis), v = cross(axis, u);
  const auto c = least_squares<3>(
    points,
    [&](const Double_3& p) {
      return std::array<double, 3>{2 * dot(p - origin, u), 2 * dot(p - origin, v), 1};
    },
    [&](const Double_3& p) {
      const double x = dot(p - origin, u), y = dot(p - origin, v);
      return x * x + y * y;
    });
  Fitted_surface<> s = surface_of_kind(Surface_kind::CYLINDER, origin + c[0] * u + c[1] * v, axis);
  s.radius = std::sqrt((std::max)(0.0, c[2] + c[0] * c[0] + c[1] * c[1]));
  return s;
}

/// The cone along `axis` with the least algebraic distance to points.
inline Fitted_surface<> cone_along(const Double_3& axis, const std::vector<Double_3>& points,
                                   const Double_3& origin)
{
  const Double_3 u = any_perpendicular(axis), v = cross(axis, u);
  // x^2 + y^2 = 2 c0 x + 2 c1 y + c2 + c3 z + c4 z^2, c4 the squared tangent of the angle
  const auto c = least_squares<5>(
    points,
    [&](const Double_3& p) {
      const Double_3 d = p - origin;
      const double z = dot(d, axis);
      return std::array<double, 5>{2 * dot(d, u), 2 * dot(d, v), 1, z, z * z};
    },
    [&](const Double_3& p) {
      const double x = dot(p - origin, u), y = dot(p - origin, v);
      return x * x + y * y;
    });
  Fitted_surface<> s = surface_of_kind(Surface_kind::CONE, origin + c[0] * u + c[1] * v, axis);
  s.radius = std::sqrt((std::max)(0.0, c[2] + c[0] * c[0] + c[1] * c[1]));
  // of a band of two circles, z and z^2 are dependent: then c4 is 0
  const double slope = s.radius > 0 ? c[3] / (2 * s.radius) : 0;
  s.angle = std::atan(c[4] > 0 ? std::copysign(std::sqrt(c[4]), c[3]) : slope);
  return s;
}

/// A line that the normals of a surface of revolution meet: its axis.
struct Axis_line
{
  Double_3 point, direction;
};

/// The line that is nearest to meeting the normals at points: the linear complex of lines with the
/// least sum of squares, without its pitch (Pottmann and Randrup, "Rotational and helical surface
/// approximation for reverse engineering", Computing 60, 1998).
inline Axis_line axis_line(const std::vector<Double_3>& points,
                           const std::vector<Double_3>& normals, const Double_3& origin)
{
  using Matrix = Eigen::Matrix<double, 3, 3, Eigen::DontAlign>;
  using Vector = Eigen::Matrix<double, 3, 1, Eigen::DontAlign>;
  Matrix nn = Matrix::Zero(), nm = Matrix::Zero(), mm = Matrix::Zero(); // sums of products
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Double_3 n = normals[p], m = cross(points[p] - origin, n);
    const double a[] = {n.x, n.y, n.z}, b[] = {m.x, m.y, m.z};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        nn(i, j) += a[i] * a[j];
        nm(i, j) += a[i] * b[j];
        mm(i, j) += b[i] * b[j];
      }
  }
  Matrix x;
  for (int j = 0; j < 3; ++j)
    x.col(j) = solve_positive_definite(nn, Vector(nm.col(j)));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        mm(i, j) -= nm(k, i) * x(k, j);
  const Double_3 c = eigenvectors(
    Symmetric_3{mm(0, 0), mm(0, 1), mm(0, 2), mm(1, 1), mm(1, 2), mm(2, 2)})[0];
  const auto times = [&](int i) { return -(x(i, 0) * c.x + x(i, 1) * c.y + x(i, 2) * c.z); };
  return {origin + cross(c, Double_3{times(0), times(1), times(2)}), c};
}

/// The torus around an axis whose meridian is the circle with the least algebraic distance to
/// points.
inline Fitted_surface<> torus_around(const Axis_line& axis, const std::vector<Double_3>& points)
{
  const Fitted_surface<> frame = surface_of_kind(Surface_kind::TORUS, axis.point, axis.direction);
  const auto c = least_squares<3>(
    points,
    [&](const Double_3& p) {
      const Meridian_point m = meridian_point(frame, p);
      return std::array<double, 3>{2 * m.r, 2 * m.z, 1};
    },
    [&](const Double_3& p) {
      const Meridian_point m = meridian_point(frame, p);
      return m.r * m.r + m.z * m.z;
    });
  Fitted_surface<> s = frame;
  s.point = axis.point + c[1] * axis.direction;
  s.radius = c[0];
  s.minor_radius = std::sqrt((std::max)(0.0, c[2] + c[0] * c[0] + c[1] * c[1]));
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

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_INITIAL_SURFACES_H
