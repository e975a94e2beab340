// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_LEAST_SQUARES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_LEAST_SQUARES_H

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Points with weights whose sum is 1.
struct Weighted_samples
{
  std::vector<Eigen::Vector3d> points;
  std::vector<double> weights;

  /// The weighted mean of the squared distances to a primitive, a function object `double operator()(point) const`.
  template <typename Primitive>
  double mean_squared_distance(const Primitive& distance) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double d = distance(points[i]);
      sum += weights[i] * d * d;
    }
    return sum;
  }
};

/// Improves a primitive by the method of Levenberg and Marquardt: minimizes the weighted mean of squared distances. The
/// points are about 1 in size. Parameters may be redundant (a point of an axis), since steps are damped.
///
/// \tparam Primitive has `static constexpr int size`, a vector of as many `parameters`, `normalize()`, and of these distances as
///         `double operator()(point) const`, and their `gradient(point)`
/// \param primitive the start, normalized
template <typename Primitive>
Primitive least_squares_fit(Primitive primitive, const Weighted_samples& samples)
{
  constexpr int most_iterations = 50;
  constexpr double least_improvement = 1e-6, largest_damping = 1e8;
  using Vector = Eigen::Matrix<double, Primitive::size, 1>;
  using Matrix = Eigen::Matrix<double, Primitive::size, Primitive::size>;
  double damping = 1e-3, error = samples.mean_squared_distance(primitive);
  for (int iteration = 0; iteration < most_iterations && error > 0; ++iteration) {
    Matrix normal_matrix = Matrix::Zero();
    Vector right_side = Vector::Zero();
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
      const Vector gradient = primitive.gradient(samples.points[i]);
      normal_matrix.template selfadjointView<Eigen::Lower>().rankUpdate(gradient, samples.weights[i]);
      right_side -= samples.weights[i] * primitive(samples.points[i]) * gradient;
    }
    bool is_better = false, has_converged = false;
    for (; !is_better && damping < largest_damping; damping *= is_better ? 0.1 : 10) {
      Primitive next = primitive;
      const Matrix damped = normal_matrix + damping * Matrix::Identity();
      next.parameters += damped.ldlt().solve(right_side);
      next.normalize();
      const double next_error = samples.mean_squared_distance(next);
      is_better = next_error < error; // false for NaN
      if (is_better) {
        has_converged = next_error > (1 - least_improvement) * error;
        primitive = next;
        error = next_error;
      }
    }
    if (!is_better || has_converged)
      break;
  }
  return primitive;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_LEAST_SQUARES_H
