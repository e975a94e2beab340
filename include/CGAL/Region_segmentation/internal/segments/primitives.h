// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVES_H

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

// Primitives as vectors of parameters, for `least_squares_fit()`. Each gives the signed distance of a point, and its gradient by
// the parameters: of an axis, which stays of length 1, only across it. Both need normalized parameters.

struct Fitted_sphere
{
  static constexpr int size = 4; // center, radius
  using Vector = Eigen::Matrix<double, size, 1>;
  Vector parameters;

  Eigen::Vector3d center() const { return parameters.head<3>(); }
  double radius() const { return parameters[3]; }
  double operator()(const Eigen::Vector3d& p) const { return (p - center()).norm() - radius(); }
  Vector gradient(const Eigen::Vector3d& p) const
  {
    Vector result;
    result << (center() - p).normalized(), -1;
    return result;
  }
  void normalize() { parameters[3] = std::abs(parameters[3]); }
};

/// Where a point is beside an axis: its coordinate along it, its distance, and the direction away from it.
struct Beside_axis
{
  Beside_axis(const Eigen::Vector3d& from_origin, const Eigen::Vector3d& axis)
    : along(from_origin.dot(axis)), across(axis.cross(from_origin).norm())
    , outward((from_origin - along * axis).normalized())
  {}

  double along, across;
  Eigen::Vector3d outward; // zero on the axis
};

struct Fitted_cylinder
{
  static constexpr int size = 7; // a point of the axis, its direction, radius
  using Vector = Eigen::Matrix<double, size, 1>;
  Vector parameters;

  Eigen::Vector3d point() const { return parameters.head<3>(); }
  Eigen::Vector3d axis() const { return parameters.segment<3>(3); }
  double radius() const { return parameters[6]; }
  double operator()(const Eigen::Vector3d& p) const { return axis().cross(p - point()).norm() - radius(); }
  Vector gradient(const Eigen::Vector3d& p) const
  {
    const Beside_axis at(p - point(), axis());
    Vector result;
    result << -at.outward, -at.along * at.outward, -1;
    return result;
  }

  /// The point of the axis nearest to the origin.
  void normalize()
  {
    const Eigen::Vector3d a = axis().normalized();
    parameters.segment<3>(3) = a;
    parameters.head<3>() -= a.dot(point()) * a;
    parameters[6] = std::abs(parameters[6]);
  }
};

struct Fitted_cone
{
  static constexpr int size = 7; // apex, axis from there, half angle
  using Vector = Eigen::Matrix<double, size, 1>;
  Vector parameters;
  double sine = 0, cosine = 1; // of the half angle

  Eigen::Vector3d apex() const { return parameters.head<3>(); }
  Eigen::Vector3d axis() const { return parameters.segment<3>(3); }
  double half_angle() const { return parameters[6]; }

  /// To the generator nearest to the point, or to the apex if the point is behind it.
  double operator()(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector3d v = p - apex(), a = axis();
    const double along = v.dot(a), across = a.cross(v).norm();
    return along * cosine + across * sine > 0 ? across * cosine - along * sine : v.norm();
  }
  Vector gradient(const Eigen::Vector3d& p) const
  {
    const Beside_axis at(p - apex(), axis());
    const double along_generator = at.along * cosine + at.across * sine;
    Vector result;
    if (along_generator > 0)
      result << sine * axis() - cosine * at.outward, -along_generator * at.outward, -along_generator;
    else
      result << (apex() - p).normalized(), Eigen::Vector4d::Zero();
    return result;
  }

  void normalize()
  {
    parameters.segment<3>(3).normalize();
    parameters[6] = (std::max)(0.0, (std::min)(CGAL_PI / 2, parameters[6]));
    sine = std::sin(half_angle());
    cosine = std::cos(half_angle());
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVES_H
