// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVE_FITTER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVE_FITTER_H

#include <CGAL/Region_segmentation/Segments/Fitted_primitive.h>
#include <CGAL/Region_segmentation/Segments/Fitted_surface.h>
#include <CGAL/Region_segmentation/internal/faces/fit_surface.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

inline Primitive_type type_of(Surface_kind kind)
{
  return kind == Surface_kind::SPHERE     ? Primitive_type::SPHERE
         : kind == Surface_kind::CYLINDER ? Primitive_type::CYLINDER
         : kind == Surface_kind::CONE     ? Primitive_type::CONE
                                          : Primitive_type::PLANE;
}

/// Fits primitives to the faces of a segment: first by linear systems in points and normals, then
/// by least squares of the distances of the corners, see `Surface_fitter`. Faces are added in a
/// system of coordinates where the centroid of the segment is the origin and its area is 1.
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
  Fitted_surface fit()
  {
    for (auto* samples : {&m_corners, &m_middles, &m_fitted_corners, &m_normals})
      normalize_weights(*samples);
    m_errors.fill(infinity);
    accept(plane());
    if (!(m_misfit > 0)) // nothing can be better, and the systems are singular
      return m_best;
    std::vector<Double_3> points;
    std::vector<double> weights;
    for (const Weighted_point& c : m_fitted_corners) {
      points.push_back(plain(c.point));
      weights.push_back(c.weight);
    }
    const Surface_fitter fitter(points, 0, std::move(weights));
    for (Fitted_surface surface : {sphere(), cylinder(), cone()})
      if (fitter(surface, most_iterations, most_slow_iterations) < infinity)
        accept(surface);
    return m_best;
  }

  /// The root mean square distance of the corners to the best primitive of each type; infinite
  /// where none was found.
  const std::array<double, 4>& errors() const { return m_errors; }

private:
  struct Weighted_point
  {
    Eigen::Vector3d point;
    double weight;
  };
  using Samples = std::vector<Weighted_point>;

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t most_fitted_faces = 2000; // errors are those of all faces
  static constexpr double tolerance = 1e-4;              // misfits below are as good as none
  static constexpr double worthwhile = 0.8; // what another parameter multiplies the misfit with
  static constexpr int most_iterations = 100, most_slow_iterations = 20; // often no surface fits
  static constexpr double largest_radius = 100;       // beyond, a surface is as good as flat
  static constexpr double smallest_half_angle = 0.01; // radians; below, a cone is a cylinder

  static void normalize_weights(Samples& samples)
  {
    double sum = 0;
    for (const Weighted_point& s : samples)
      sum += s.weight;
    for (Weighted_point& s : samples)
      s.weight = sum > 0 ? s.weight / sum : 1 / double(samples.size());
  }

  static Double_3 plain(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

  static bool is_proper(const Fitted_surface& surface)
  {
    const bool is_cone = surface.kind == Surface_kind::CONE;
    if (is_cone && !(surface.angle >= smallest_half_angle &&
                     surface.angle <= CGAL_PI / 2 - smallest_half_angle))
      return false;
    return (is_cone ? norm(surface.apex()) : surface.radius) <= largest_radius;
  }

  static double mean_squared_distance(const Surface_distance& distance, const Samples& samples)
  {
    double sum = 0;
    for (const Weighted_point& s : samples) {
      const double d = distance(plain(s.point));
      sum += s.weight * d * d;
    }
    return sum;
  }

  /// Compares by the misfit: the root mean square distance of corners and middles of faces
  /// together. Corners alone do not tell a cylinder or a cone from a sphere if they lie on two
  /// circles, as on many machine parts.
  void accept(const Fitted_surface& surface)
  {
    const Surface_distance distance(surface);
    const double at_corners = mean_squared_distance(distance, m_corners);
    const double misfit = std::sqrt((at_corners + mean_squared_distance(distance, m_middles)) / 2);
    if (!is_proper(surface) || !std::isfinite(misfit))
      return;
    m_errors[std::size_t(type_of(surface.kind))] = std::sqrt(at_corners);
    if (m_misfit > tolerance && misfit < worthwhile * m_misfit) {
      m_misfit = misfit;
      m_best = surface;
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

  Fitted_surface plane() const
  {
    const Eigen::Vector3d center = mean(m_corners), normal = least_direction(m_corners, center);
    Fitted_surface result;
    result.kind = Surface_kind::PLANE;
    result.point = plain(center);
    result.direction = plain(normal.dot(mean(m_normals)) < 0 ? Eigen::Vector3d(-normal) : normal);
    return result;
  }

  /// Of samples p by the solution (c, s) of 2 c.p + s = |p|^2 in the least squares sense, where
  /// s = r^2 - |c|^2. If they lie in a plane through the origin, it is a circle.
  static Fitted_surface sphere_through(const Samples& samples)
  {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right_side = Eigen::Vector4d::Zero();
    for (const Weighted_point& s : samples) {
      const Eigen::Vector4d row = (2 * s.point).homogeneous();
      matrix += s.weight * row * row.transpose();
      right_side += s.weight * s.point.squaredNorm() * row;
    }
    const Eigen::Vector4d solution = matrix.completeOrthogonalDecomposition().solve(right_side);
    Fitted_surface result;
    result.kind = Surface_kind::SPHERE;
    result.point = plain(solution.head<3>());
    result.radius = std::sqrt((std::max)(0.0, solution[3] + squared_norm(result.point)));
    return result;
  }

  Fitted_surface sphere() const { return sphere_through(m_fitted_corners); }

  /// The normals of a cylinder are perpendicular to its axis; along the axis, it is a circle.
  Fitted_surface cylinder() const
  {
    const Eigen::Vector3d axis = least_direction(m_normals, Eigen::Vector3d::Zero());
    Samples projected = m_fitted_corners;
    for (Weighted_point& s : projected)
      s.point -= axis.dot(s.point) * axis;
    Fitted_surface result = sphere_through(projected);
    result.kind = Surface_kind::CYLINDER;
    result.direction = plain(axis);
    return result;
  }

  /// The normals of a cone lie on a circle around its axis, and its tangent planes meet in the
  /// apex.
  Fitted_surface cone() const
  {
    const Eigen::Vector3d mean_normal = mean(m_normals);
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < m_normals.size(); ++i) {
      const auto& [normal, weight] = m_normals[i];
      matrix += weight * normal * normal.transpose();
      right_side += weight * m_plane_offsets[i] * normal;
    }
    const Eigen::Vector3d apex = matrix.completeOrthogonalDecomposition().solve(right_side);
    Eigen::Vector3d axis = least_direction(m_normals, mean_normal);
    if (apex.dot(axis) > 0) // from the apex to the centroid, the origin
      axis = -axis;
    Fitted_surface result;
    result.kind = Surface_kind::CONE;
    result.point = plain(apex);
    result.direction = plain(axis);
    result.angle = std::asin((std::min)(1.0, std::abs(mean_normal.dot(axis))));
    return result;
  }

  const std::size_t m_stride;
  std::size_t m_number_of_faces = 0;
  Samples m_corners, m_middles;        // of all faces
  Samples m_fitted_corners, m_normals; // of every `m_stride`-th face
  std::vector<double> m_plane_offsets; // of the faces of these normals, from the origin
  std::array<double, 4> m_errors;
  Fitted_surface m_best;
  double m_misfit = infinity;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVE_FITTER_H
