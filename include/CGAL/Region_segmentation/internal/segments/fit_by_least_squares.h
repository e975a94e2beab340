// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_FIT_BY_LEAST_SQUARES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_FIT_BY_LEAST_SQUARES_H

#include <CGAL/Region_segmentation/internal/segments/Primitive_shape.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A point with a weight; those of all samples add up to 1.
struct Weighted_point
{
  Eigen::Vector3d point;
  double weight;
};

inline double mean_squared_distance(const Primitive_shape& shape,
                                    const std::vector<Weighted_point>& samples)
{
  double sum = 0;
  for (const Weighted_point& s : samples)
    sum += s.weight * shape.distance(s.point) * shape.distance(s.point);
  return sum;
}

/// Minimizes the mean squared distance from a start, by the method of Levenberg and Marquardt. The
/// points are about 1 in size. Parameters may be redundant (a point of an axis) or unused, since
/// steps are damped.
inline Primitive_shape fit_by_least_squares(Primitive_shape shape,
                                            const std::vector<Weighted_point>& samples)
{
  constexpr int most_iterations = 50;
  constexpr double least_improvement = 1e-6, largest_damping = 1e8;
  using Vector = Primitive_shape::Gradient;
  using Matrix = Eigen::Matrix<double, 8, 8>;
  double damping = 1e-3, error = mean_squared_distance(shape, samples);
  for (int iteration = 0; iteration < most_iterations && error > 0; ++iteration) {
    Matrix normal_matrix = Matrix::Zero();
    Vector right_side = Vector::Zero();
    for (const Weighted_point& s : samples) {
      const Vector gradient = shape.gradient(s.point);
      normal_matrix += s.weight * gradient * gradient.transpose();
      right_side -= s.weight * shape.distance(s.point) * gradient;
    }
    const double previous = error;
    for (; !(error < previous) && damping < largest_damping;
         damping *= error < previous ? 0.1 : 10) {
      Primitive_shape next = shape;
      next.move((normal_matrix + damping * Matrix::Identity()).ldlt().solve(right_side));
      const double next_error = mean_squared_distance(next, samples);
      if (next_error < previous) { // false for NaN
        shape = next;
        error = next_error;
      }
    }
    if (!(error < (1 - least_improvement) * previous))
      break;
  }
  return shape;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_FIT_BY_LEAST_SQUARES_H
