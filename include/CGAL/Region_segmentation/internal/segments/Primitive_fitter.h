// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVE_FITTER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVE_FITTER_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Segments/Fitted_primitive.h>
#include <CGAL/Region_segmentation/internal/segments/Least_squares.h>
#include <CGAL/Region_segmentation/internal/segments/primitives.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

inline Eigen::Vector3d to_eigen(const Double_3& v)
{
  return {v.x, v.y, v.z};
}

inline Double_3 from_eigen(const Eigen::Vector3d& v)
{
  return {v[0], v[1], v[2]};
}

/// Fits primitives to the faces of a segment: first by linear systems in points and normals, then by least squares of
/// the distances of the corners. Points are relative to the centroid, in units of the square root of the area.
class Primitive_fitter
{
public:
  /// \tparam FaceRange a range of indices of faces
  template <typename FaceRange>
  Primitive_fitter(const Flat_mesh& mesh, const FaceRange& faces, const Double_3& centroid, double area)
    : m_centroid(to_eigen(centroid)), m_unit(area > 0 ? std::sqrt(area) : 1)
  {
    const Mesh_points& points = mesh.points();
    const std::size_t stride = (faces.size() + most_faces - 1) / most_faces;
    std::size_t i = 0;
    for (auto f : faces) {
      const std::size_t n = points.number_of_corners(f);
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t c = 0; c < n; ++c) {
        add_point(m_all, to_eigen(points[points.corner(f, c)]), mesh.area(f) / double(n));
        sum += to_eigen(points[points.corner(f, c)]);
      }
      add_point(m_middles, sum / double(n), mesh.area(f));
      if (i++ % stride != 0)
        continue;
      for (std::size_t c = 0; c < n; ++c)
        add_point(m_some, to_eigen(points[points.corner(f, c)]), mesh.area(f) / double(n));
      m_normals.push_back(to_eigen(mesh.normal(f)));
      m_first_corner.push_back(m_some.points.size() - n);
      m_areas.push_back(mesh.area(f));
    }
    normalize_weights(m_all.weights);
    normalize_weights(m_middles.weights);
    normalize_weights(m_some.weights);
    normalize_weights(m_areas);
  }

  Fitted_primitive fit()
  {
    m_errors.fill(infinity);
    fit_plane();
    if (m_plane.misfit > 0) { // otherwise nothing can be better, and the systems are singular
      fit_sphere();
      fit_cylinder();
      fit_cone();
    }
    Fitted_primitive best = simplest_good();
    for (std::size_t i = 0; i < m_errors.size(); ++i)
      best.errors[i] = m_errors[i] * m_unit;
    best.error *= m_unit;
    best.radius *= m_unit;
    best.point = from_eigen(m_centroid + m_unit * to_eigen(best.point));
    return best;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t most_faces = 2000; // for fitting; errors are those of all faces
  static constexpr double tolerance = 1e-4;       // misfits below are as good as none
  static constexpr double worthwhile = 0.8;       // what another parameter must multiply the misfit with
  static constexpr double largest_radius = 100;   // beyond, a surface is as good as flat
  static constexpr double smallest_half_angle = 0.01; // radians; below, a cone is a cylinder

  void add_point(Weighted_samples& samples, const Eigen::Vector3d& p, double weight) const
  {
    samples.points.push_back((p - m_centroid) / m_unit);
    samples.weights.push_back(weight);
  }

  static void normalize_weights(std::vector<double>& weights)
  {
    double sum = 0;
    for (double w : weights)
      sum += w;
    for (double& w : weights)
      w = sum > 0 ? w / sum : 1 / double(weights.size());
  }

  /// A primitive, and its misfit: the root mean square distance of corners and middles of faces together. Corners alone do not
  /// tell a cylinder or a cone from a sphere if they lie on two circles, as on many machine parts.
  struct Candidate
  {
    Fitted_primitive primitive;
    double misfit = infinity;
  };

  template <typename Distance>
  void accept(Candidate& candidate, const Fitted_primitive& primitive, const Distance& distance)
  {
    const double at_corners = m_all.mean_squared_distance(distance), in_middles = m_middles.mean_squared_distance(distance);
    if (!std::isfinite(at_corners + in_middles))
      return;
    candidate.primitive = primitive;
    candidate.primitive.error = m_errors[std::size_t(primitive.type)] = std::sqrt(at_corners);
    candidate.misfit = std::sqrt((at_corners + in_middles) / 2);
  }

  /// The simplest primitive than which no more complex one is better by far.
  Fitted_primitive simplest_good() const
  {
    const Candidate* best = &m_plane;
    for (const Candidate* other : {&m_sphere, &m_cylinder, &m_cone})
      if (best->misfit > tolerance && other->misfit < worthwhile * best->misfit)
        best = other;
    return best->primitive;
  }

  /// The eigenvectors of a weighted covariance of points, by increasing eigenvalue.
  static Eigen::Matrix3d principal_directions(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& weights,
                                              const Eigen::Vector3d& mean)
  {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i)
      covariance += weights[i] * (points[i] - mean) * (points[i] - mean).transpose();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
  }

  static Eigen::Vector3d weighted_mean(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& weights)
  {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i)
      mean += weights[i] * points[i];
    return mean;
  }

  void fit_plane()
  {
    const Eigen::Vector3d mean = weighted_mean(m_all.points, m_all.weights);
    Eigen::Vector3d normal = principal_directions(m_all.points, m_all.weights, mean).col(0);
    if (normal.dot(weighted_mean(m_normals, m_areas)) < 0)
      normal = -normal;
    Fitted_primitive plane;
    plane.point = from_eigen(mean);
    plane.direction = from_eigen(normal);
    accept(m_plane, plane, [&](const Eigen::Vector3d& p) { return normal.dot(p - mean); });
  }

  struct Center_and_radius
  {
    Eigen::Vector3d center;
    double radius;
  };

  /// Of a sphere, or of a circle if the points p lie in a plane through the origin: by the solution (c, s) of
  /// 2 c.p + s = |p|^2 in the least squares sense, s = r^2 - |c|^2.
  static Center_and_radius algebraic_sphere(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& weights)
  {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right_side = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector4d row(2 * points[i][0], 2 * points[i][1], 2 * points[i][2], 1);
      matrix += weights[i] * row * row.transpose();
      right_side += weights[i] * points[i].squaredNorm() * row;
    }
    const Eigen::Vector4d solution = matrix.completeOrthogonalDecomposition().solve(right_side);
    const Eigen::Vector3d center = solution.head<3>();
    return {center, std::sqrt((std::max)(0.0, solution[3] + center.squaredNorm()))};
  }

  void fit_sphere()
  {
    const Center_and_radius first = algebraic_sphere(m_some.points, m_some.weights);
    Fitted_sphere sphere;
    sphere.parameters << first.center, first.radius;
    sphere = least_squares_fit(sphere, m_some);
    if (!(sphere.radius() <= largest_radius))
      return;
    Fitted_primitive result;
    result.type = Primitive_type::SPHERE;
    result.point = from_eigen(sphere.center());
    result.radius = sphere.radius();
    accept(m_sphere, result, sphere);
  }

  /// The normals of a cylinder are perpendicular to its axis; along the axis, it is a circle.
  void fit_cylinder()
  {
    const Eigen::Vector3d axis = principal_directions(m_normals, m_areas, Eigen::Vector3d::Zero()).col(0);
    std::vector<Eigen::Vector3d> projected = m_some.points;
    for (Eigen::Vector3d& p : projected)
      p -= axis.dot(p) * axis;
    const Center_and_radius circle = algebraic_sphere(projected, m_some.weights);
    Fitted_cylinder cylinder;
    cylinder.parameters << circle.center, axis, circle.radius;
    cylinder.normalize();
    cylinder = least_squares_fit(cylinder, m_some);
    if (!(cylinder.radius() <= largest_radius))
      return;
    Fitted_primitive result;
    result.type = Primitive_type::CYLINDER;
    result.point = from_eigen(cylinder.point());
    result.direction = from_eigen(cylinder.axis());
    result.radius = cylinder.radius();
    accept(m_cylinder, result, cylinder);
  }

  /// The normals of a cone lie on a circle around its axis, and its tangent planes meet in the apex.
  void fit_cone()
  {
    const Eigen::Vector3d mean_normal = weighted_mean(m_normals, m_areas);
    Eigen::Vector3d axis = principal_directions(m_normals, m_areas, mean_normal).col(0);
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < m_normals.size(); ++i) {
      matrix += m_areas[i] * m_normals[i] * m_normals[i].transpose();
      right_side += m_areas[i] * m_normals[i].dot(m_some.points[m_first_corner[i]]) * m_normals[i];
    }
    const Eigen::Vector3d apex = matrix.completeOrthogonalDecomposition().solve(right_side);
    if (apex.dot(axis) > 0) // the centroid is the origin: the axis points from the apex to it
      axis = -axis;
    Fitted_cone cone;
    cone.parameters << apex, axis, std::asin((std::min)(1.0, std::abs(mean_normal.dot(axis))));
    cone.normalize();
    cone = least_squares_fit(cone, m_some);
    if (!(cone.apex().norm() <= largest_radius && cone.half_angle() >= smallest_half_angle &&
          cone.half_angle() <= CGAL_PI / 2 - smallest_half_angle))
      return;
    Fitted_primitive result;
    result.type = Primitive_type::CONE;
    result.point = from_eigen(cone.apex());
    result.direction = from_eigen(cone.axis());
    result.half_angle = cone.half_angle();
    accept(m_cone, result, cone);
  }

  Eigen::Vector3d m_centroid;
  double m_unit;
  Weighted_samples m_all, m_some; // corners, of all faces and of some
  Weighted_samples m_middles;     // of all faces
  std::vector<Eigen::Vector3d> m_normals; // of some faces
  std::vector<std::size_t> m_first_corner;
  std::vector<double> m_areas;
  std::array<double, 4> m_errors;
  Candidate m_plane, m_sphere, m_cylinder, m_cone;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_PRIMITIVE_FITTER_H
