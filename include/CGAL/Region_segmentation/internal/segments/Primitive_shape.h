// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVE_SHAPE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVE_SHAPE_H

#include <CGAL/Region_segmentation/Segments/Fitted_primitive.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A primitive with the distances of points, and their derivatives. Members as in
/// `Fitted_primitive`. A cylinder is the cone with its radius around its point, and half angle 0; a
/// cone has radius 0 around its apex.
struct Primitive_shape
{
  /// The derivatives of a distance by point, direction, radius and half angle.
  using Gradient = Eigen::Matrix<double, 8, 1>;

  Primitive_type type = Primitive_type::PLANE;
  Eigen::Vector3d point = Eigen::Vector3d::Zero(), direction = Eigen::Vector3d::Zero();
  double radius = 0, half_angle = 0;

  /// Signed: to the generator nearest to the point, or to the apex if the point is behind it.
  double distance(const Eigen::Vector3d& p) const
  {
    if (type == Primitive_type::PLANE)
      return direction.dot(p - point);
    if (type == Primitive_type::SPHERE)
      return (p - point).norm() - radius;
    const double along = direction.dot(p - point), across = direction.cross(p - point).norm();
    if (type == Primitive_type::CYLINDER)
      return across - radius;
    const double sine = std::sin(half_angle), cosine = std::cos(half_angle);
    return along * cosine + across * sine > 0 ? across * cosine - along * sine : (p - point).norm();
  }

  /// Of the distance to a sphere, cylinder or cone. The direction, which stays of length 1, counts
  /// only across.
  Gradient gradient(const Eigen::Vector3d& p) const
  {
    Gradient result = Gradient::Zero();
    const Eigen::Vector3d v = p - point;
    const double sine = std::sin(half_angle), cosine = std::cos(half_angle),
                 along = v.dot(direction);
    const double along_generator = along * cosine + direction.cross(v).norm() * sine;
    const Eigen::Vector3d outward = (v - along * direction).normalized(); // zero on the axis
    if (type == Primitive_type::SPHERE || (type == Primitive_type::CONE && along_generator <= 0))
      result.head<3>() = -v.normalized();
    else {
      result.head<3>() = sine * direction - cosine * outward;
      result.segment<3>(3) = -along_generator * outward;
      result[7] = type == Primitive_type::CONE ? -along_generator : 0;
    }
    result[6] = type == Primitive_type::CONE ? 0 : -1;
    return result;
  }

  /// Adds to the parameters, and brings them to their one form.
  void move(const Gradient& step)
  {
    point += step.head<3>();
    direction = (direction + step.segment<3>(3)).normalized();
    radius = std::abs(radius + step[6]);
    half_angle = (std::max)(0.0, (std::min)(CGAL_PI / 2, half_angle + step[7]));
    if (type == Primitive_type::CYLINDER) // the point of the axis nearest to the origin
      point -= direction.dot(point) * direction;
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVE_SHAPE_H
