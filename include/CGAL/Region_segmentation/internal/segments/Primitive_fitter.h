// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVE_FITTER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVE_FITTER_H

#include <CGAL/Region_segmentation/internal/segments/Primitive_shape.h>
#include <CGAL/Region_segmentation/internal/segments/fit_by_least_squares.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Fits primitives to the faces of a segment: first by linear systems in points and normals, then
/// by least squares of the distances of the corners. Faces are added in a system of coordinates
/// where the centroid of the segment is the origin and its area is 1.
class Primitive_fitter
{
public:
  explicit Primitive_fitter(std::size_t number_of_faces)
    : m_stride((number_of_faces + most_fitted_faces - 1) / most_fitted_faces)
  {}

  /// `normal`: zero for a degenerate face.
  void add_face(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& normal,
                double area)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : corners)
      sum += p;
    const double n = double(corners.size());
    m_middles.push_back({sum / n, area});
    const bool is_fitted = m_number_of_faces++ % m_stride == 0;
    for (const Eigen::Vector3d& p : corners) {
      m_corners.push_back({p, area / n});
      if (is_fitted)
        m_fitted_corners.push_back({p, area / n});
    }
    if (is_fitted) {
      m_normals.push_back({normal, area});
      m_plane_offsets.push_back(normal.dot(corners[0]));
    }
  }

  /// The simplest primitive than which no more complex one is better by far.
  Primitive_shape fit()
  {
    for (auto* samples : {&m_corners, &m_middles, &m_fitted_corners, &m_normals})
      normalize_weights(*samples);
    m_errors.fill(infinity);
    accept(plane());
    if (m_misfit > 0) // otherwise nothing can be better, and the systems are singular
      for (const Primitive_shape& start : {sphere(), cylinder(), cone()})
        accept(fit_by_least_squares(start, m_fitted_corners));
    return m_best;
  }

  /// The root mean square distance of the corners to the best primitive of each type; infinite
  /// where none was found.
  const std::array<double, 4>& errors() const { return m_errors; }

private:
  using Samples = std::vector<Weighted_point>;

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t most_fitted_faces = 2000; // errors are those of all faces
  static constexpr double tolerance = 1e-4;              // misfits below are as good as none
  static constexpr double worthwhile = 0.8;     // what another parameter multiplies the misfit with
  static constexpr double largest_radius = 100; // beyond, a surface is as good as flat
  static constexpr double smallest_half_angle = 0.01; // radians; below, a cone is a cylinder

  static void normalize_weights(Samples& samples)
  {
    double sum = 0;
    for (const Weighted_point& s : samples)
      sum += s.weight;
    for (Weighted_point& s : samples)
      s.weight = sum > 0 ? s.weight / sum : 1 / double(samples.size());
  }

  static bool is_proper(const Primitive_shape& shape)
  {
    const bool is_cone = shape.type == Primitive_type::CONE;
    if (is_cone && !(shape.half_angle >= smallest_half_angle &&
                     shape.half_angle <= CGAL_PI / 2 - smallest_half_angle))
      return false;
    return (is_cone ? shape.point.norm() : shape.radius) <= largest_radius;
  }

  /// Compares by the misfit: the root mean square distance of corners and middles of faces
  /// together. Corners alone do not tell a cylinder or a cone from a sphere if they lie on two
  /// circles, as on many machine parts.
  void accept(const Primitive_shape& shape)
  {
    const double at_corners = mean_squared_distance(shape, m_corners);
    const double misfit = std::sqrt((at_corners + mean_squared_distance(shape, m_middles)) / 2);
    if (!is_proper(shape) || !std::isfinite(misfit))
      return;
    m_errors[std::size_t(shape.type)] = std::sqrt(at_corners);
    if (m_misfit > tolerance && misfit < worthwhile * m_misfit) {
      m_misfit = misfit;
      m_best = shape;
    }
  }

  static Eigen::Vector3d mean(const Samples& samples)
  {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (const Weighted_point& s : samples)
      result += s.weight * s.point;
    return result;
  }

  /// The direction in which samples are least spread.
  static Eigen::Vector3d least_direction(const Samples& samples, const Eigen::Vector3d& center)
  {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Weighted_point& s : samples)
      covariance += s.weight * (s.point - center) * (s.point - center).transpose();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0);
  }

  Primitive_shape plane() const
  {
    Primitive_shape result;
    result.point = mean(m_corners);
    result.direction = least_direction(m_corners, result.point);
    if (result.direction.dot(mean(m_normals)) < 0)
      result.direction = -result.direction;
    return result;
  }

  /// Of samples p by the solution (c, s) of 2 c.p + s = |p|^2 in the least squares sense, where
  /// s = r^2 - |c|^2. If they lie in a plane through the origin, it is a circle.
  static Primitive_shape sphere_through(const Samples& samples)
  {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right_side = Eigen::Vector4d::Zero();
    for (const Weighted_point& s : samples) {
      const Eigen::Vector4d row = (2 * s.point).homogeneous();
      matrix += s.weight * row * row.transpose();
      right_side += s.weight * s.point.squaredNorm() * row;
    }
    const Eigen::Vector4d solution = matrix.completeOrthogonalDecomposition().solve(right_side);
    Primitive_shape result;
    result.type = Primitive_type::SPHERE;
    result.point = solution.head<3>();
    result.radius = std::sqrt((std::max)(0.0, solution[3] + result.point.squaredNorm()));
    return result;
  }

  Primitive_shape sphere() const { return sphere_through(m_fitted_corners); }

  /// The normals of a cylinder are perpendicular to its axis; along the axis, it is a circle.
  Primitive_shape cylinder() const
  {
    const Eigen::Vector3d axis = least_direction(m_normals, Eigen::Vector3d::Zero());
    Samples projected = m_fitted_corners;
    for (Weighted_point& s : projected)
      s.point -= axis.dot(s.point) * axis;
    Primitive_shape result = sphere_through(projected);
    result.type = Primitive_type::CYLINDER;
    result.direction = axis;
    result.move(Primitive_shape::Gradient::Zero());
    return result;
  }

  /// The normals of a cone lie on a circle around its axis, and its tangent planes meet in the
  /// apex.
  Primitive_shape cone() const
  {
    const Eigen::Vector3d mean_normal = mean(m_normals);
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < m_normals.size(); ++i) {
      const auto& [normal, weight] = m_normals[i];
      matrix += weight * normal * normal.transpose();
      right_side += weight * m_plane_offsets[i] * normal;
    }
    Primitive_shape result;
    result.type = Primitive_type::CONE;
    result.point = matrix.completeOrthogonalDecomposition().solve(right_side);
    result.direction = least_direction(m_normals, mean_normal);
    if (result.point.dot(result.direction) > 0) // from the apex to the centroid, the origin
      result.direction = -result.direction;
    result.half_angle = std::asin((std::min)(1.0, std::abs(mean_normal.dot(result.direction))));
    return result;
  }

  const std::size_t m_stride;
  std::size_t m_number_of_faces = 0;
  Samples m_corners, m_middles;        // of all faces
  Samples m_fitted_corners, m_normals; // of every `m_stride`-th face
  std::vector<double> m_plane_offsets; // of the faces of these normals, from the origin
  std::array<double, 4> m_errors;
  Primitive_shape m_best;
  double m_misfit = infinity;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVE_FITTER_H
