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

// Primitives as vectors of parameters, for `least_squares_fit()`. Each gives the signed distance of a point.

struct Fitted_sphere
{
  static constexpr int size = 4; // center, radius
  Eigen::Matrix<double, size, 1> parameters;

  Eigen::Vector3d center() const { return parameters.head<3>(); }
  double radius() const { return parameters[3]; }
  double operator()(const Eigen::Vector3d& p) const { return (p - center()).norm() - radius(); }
  void normalize() { parameters[3] = std::abs(parameters[3]); }
};

struct Fitted_cylinder
{
  static constexpr int size = 7; // a point of the axis, its direction, radius
  Eigen::Matrix<double, size, 1> parameters;

  Eigen::Vector3d point() const { return parameters.head<3>(); }
  Eigen::Vector3d axis() const { return parameters.segment<3>(3).normalized(); }
  double radius() const { return parameters[6]; }
  double operator()(const Eigen::Vector3d& p) const { return axis().cross(p - point()).norm() - radius(); }

  /// The point of the axis nearest to the origin.
  void normalize()
  {
    const Eigen::Vector3d a = axis();
    parameters.segment<3>(3) = a;
    parameters.head<3>() -= a.dot(point()) * a;
    parameters[6] = std::abs(parameters[6]);
  }
};

struct Fitted_cone
{
  static constexpr int size = 7; // apex, axis from there, half angle
  Eigen::Matrix<double, size, 1> parameters;

  Eigen::Vector3d apex() const { return parameters.head<3>(); }
  Eigen::Vector3d axis() const { return parameters.segment<3>(3).normalized(); }
  double half_angle() const { return parameters[6]; }

  /// To the generator nearest to the point, or to the apex if the point is behind it.
  double operator()(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector3d v = p - apex(), a = axis();
    const double along = v.dot(a), across = a.cross(v).norm();
    const double sine = std::sin(half_angle()), cosine = std::cos(half_angle());
    return along * cosine + across * sine > 0 ? across * cosine - along * sine : v.norm();
  }

  void normalize()
  {
    parameters.segment<3>(3) = axis();
    parameters[6] = (std::max)(0.0, (std::min)(CGAL_PI / 2, parameters[6]));
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVES_H
