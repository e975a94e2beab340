// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_INTERNAL_SEGMENT_FITTER_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_INTERNAL_SEGMENT_FITTER_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/initial_surfaces.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

struct Weighted_points
{
  std::vector<Double_3> points;
  std::vector<double> weights;

  void add(const Double_3& point, double weight)
  {
    points.push_back(point);
    weights.push_back(weight);
  }
};

/// The sphere with the least squared powers of the points p: by the solution (c, s) of
/// 2 c.p + s = |p|^2 in the least squares sense, where s = r^2 - |c|^2. Of points in a plane
/// through the origin it is that of their circle.
inline Fitted_surface<> sphere_through(const Weighted_points& samples)
{
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right_side = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Double_3& p = samples.points[i];
    const Eigen::Vector4d row(2 * p.x, 2 * p.y, 2 * p.z, 1);
    matrix += samples.weights[i] * row * row.transpose();
    right_side += samples.weights[i] * squared_norm(p) * row;
  }
  const Eigen::Vector4d solution = matrix.completeOrthogonalDecomposition().solve(right_side);
  Fitted_surface<> result = surface_of_kind(Surface_kind::SPHERE,
                                            {solution[0], solution[1], solution[2]}, {0, 0, 1});
  result.radius = std::sqrt((std::max)(0.0, solution[3] + squared_norm(result.point)));
  return result;
}

/// Fits surfaces to the faces of a segment: first by linear systems in points and normals, then by
/// least squares of the distances of the corners, see `Surface_fitter`. Faces are added in a system
/// of coordinates where the centroid of the segment is the origin and its area is 1.
class Segment_fitter
{
public:
  /// `normal`: zero for a degenerate face.
  void add_face(const std::vector<Double_3>& corners, const Double_3& normal, double weight)
  {
    const double share = weight / double(corners.size());
    Double_3 sum{0, 0, 0};
    for (const Double_3& p : corners) {
      sum = sum + p;
      m_corners.add(p, share);
      m_moments.add(share, p);
    }
    m_middles.add(1 / double(corners.size()) * sum, weight);
    m_normals.push_back(normal);
    m_normal_moments.add(weight, normal);
    m_offsets = m_offsets + weight * dot(normal, corners[0]) * normal;
  }

  /// The length of the faces along an axis.
  double extent(const Double_3& axis) const
  {
    Fitted_surface<> plane = surface_of_kind(Surface_kind::PLANE, {0, 0, 0}, axis);
    measure(plane, m_corners.points);
    return plane.highest - plane.lowest;
  }

  /// The simplest surface than which no more complex one is better by far. `errors`: by kind, the
  /// root mean square distance of the corners to the best surface; infinite where none was found.
  ///
  /// Surfaces are compared by the misfit: the root mean square distance of corners and middles of
  /// faces together. Corners alone do not tell a cylinder or a cone from a sphere if they lie on
  /// two circles, as on many machine parts.
  Fitted_surface<> fit(std::array<double, 4>& errors) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Weighted_points fitted;
    for (std::size_t i = 0; i < m_corners.points.size();
         i += (m_corners.points.size() + most_fitted - 1) / most_fitted)
      fitted.add(m_corners.points[i], m_corners.weights[i]);
    const Surface_fitter corners(m_corners.points, 0, m_corners.weights),
      middles(m_middles.points, 0, m_middles.weights), fitter(fitted.points, 0, fitted.weights);
    Fitted_surface<> best;
    double least = infinity;
    const auto accept = [&](const Fitted_surface<>& s) {
      double& error = errors[std::size_t(s.kind)];
      error = corners.root_mean_square(s);
      const double misfit = std::hypot(error, middles.root_mean_square(s)) / std::sqrt(2.0);
      if (least > tolerance && misfit < worthwhile * least) {
        least = misfit;
        best = s;
      }
    };
    errors.fill(infinity);
    accept(plane());
    if (least > 0) // else nothing can be better, and the systems are singular
      for (Fitted_surface<> s : {sphere_through(fitted), cylinder(fitted), cone()})
        if (fitter(s, most_iterations, most_slow_iterations) < infinity)
          accept(s);
    move_along_axis(best, {0, 0, 0});
    measure(best, m_corners.points);
    double outwards = 0;
    for (std::size_t i = 0; i < m_normals.size(); ++i)
      outwards += m_middles.weights[i] *
                  dot(m_normals[i], surface_normal(best, m_middles.points[i]));
    best.side = outwards < 0 ? -1 : 1;
    return best;
  }

private:
  static constexpr std::size_t most_fitted = 6000; // corners; errors are those of all
  static constexpr double tolerance = 1e-4;        // misfits below are as good as none
  static constexpr double worthwhile = 0.8; // what another parameter multiplies the misfit with
  static constexpr int most_iterations = 100, most_slow_iterations = 20; // often no surface fits

  Fitted_surface<> plane() const
  {
    const Double_3 normal = eigenvectors(m_moments.covariance())[0];
    return surface_of_kind(Surface_kind::PLANE, m_moments.centroid(),
                           dot(normal, m_normal_moments.first) < 0 ? -1.0 * normal : normal);
  }

  /// The normals of a cylinder are perpendicular to its axis.
  Fitted_surface<> cylinder(const Weighted_points& fitted) const
  {
    return cylinder_along(eigenvectors(m_normal_moments.second)[0], fitted.points, {0, 0, 0});
  }

  /// The normals of a cone lie on a circle around its axis, and its tangent planes meet in the
  /// apex. The axis leads from the apex to the centroid, which is the origin.
  Fitted_surface<> cone() const
  {
    const Eigen::Vector3d apex = to_eigen(m_normal_moments.second)
                                   .completeOrthogonalDecomposition()
                                   .solve(Eigen::Vector3d(m_offsets.x, m_offsets.y, m_offsets.z));
    Fitted_surface<> result = surface_of_kind(Surface_kind::CONE, {apex[0], apex[1], apex[2]},
                                              eigenvectors(m_normal_moments.covariance())[0]);
    if (dot(result.point, result.direction) > 0)
      result.direction = -1.0 * result.direction;
    result.angle = std::asin(
      (std::min)(1.0, std::fabs(dot(m_normal_moments.centroid(), result.direction))));
    return result;
  }

  Weighted_points m_corners, m_middles;       // of all faces
  std::vector<Double_3> m_normals;            // by face
  Second_moments m_moments, m_normal_moments; // of corners and of normals
  Double_3 m_offsets{0, 0, 0}; // the sum of (n.p) n: p on the plane of a face, n its normal
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_INTERNAL_SEGMENT_FITTER_H
