// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIT_SURFACE_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIT_SURFACE_H

#include <CGAL/Region_segmentation/Graph/Region_shapes.h>
#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

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

inline Eigen::Matrix3d to_eigen(const Symmetric_3& m)
{
  Eigen::Matrix3d result;
  result << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  return result;
}

/// Of length 1 and orthogonal to each other, that of the smallest eigenvalue first.
inline std::array<Double_3, 3> eigenvectors(const Symmetric_3& m)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(to_eigen(m));
  const Eigen::Matrix3d& v = solver.eigenvectors();
  return {Double_3{v(0, 0), v(1, 0), v(2, 0)}, Double_3{v(0, 1), v(1, 1), v(2, 1)},
          Double_3{v(0, 2), v(1, 2), v(2, 2)}};
}

/// Solves a x = b by the decomposition a = l d l^T, without pivoting; only the lower triangle of
/// `a` is read. Unknowns that those before them determine are 0. Eigen's decompositions sum in
/// the order of the vector unit, and fuse products and sums where it can: their last bits, and
/// through them faces, would depend on the processor.
template <typename Matrix, typename Vector>
Vector solve_positive_definite(Matrix a, Vector b)
{
  constexpr double rounding = 1e-13;
  const int n = int(b.size());
  const Vector diagonal = a.diagonal();
  const auto quotient = [&](double x, int j) {
    return a(j, j) > rounding * diagonal[j] ? x / a(j, j) : 0;
  };
  for (int j = 0; j < n; ++j) // below the diagonal l, on it d
    for (int i = j; i < n; ++i) {
      for (int k = 0; k < j; ++k)
        a(i, j) -= a(i, k) * a(j, k) * a(k, k);
      if (i > j)
        a(i, j) = quotient(a(i, j), j);
    }
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < i; ++k)
      b[i] -= a(i, k) * b[k];
  for (int i = n - 1; i >= 0; --i) {
    b[i] = quotient(b[i], i);
    for (int k = i + 1; k < n; ++k)
      b[i] -= a(k, i) * b[k];
  }
  return b;
}

/// The number of parameters of a surface.
inline int degrees_of_freedom(Surface_kind kind)
{
  constexpr int numbers[] = {3, 5, 6, 4, 7, 0};
  return numbers[int(kind)];
}

/// A direction orthogonal to one of length 1.
inline Double_3 any_perpendicular(const Double_3& a)
{
  const Double_3 axis = std::fabs(a.x) < 0.6 ? Double_3{1, 0, 0} : Double_3{0, 1, 0};
  const Double_3 b = cross(a, axis);
  return (1 / norm(b)) * b;
}

inline double largest_distance(const Fitted_surface<>& s, const std::vector<Double_3>& points)
{
  const Surface_distance distance(s);
  double largest = 0;
  for (const Double_3& p : points)
    largest = (std::max)(largest, std::fabs(distance(p)));
  return largest;
}

/// Moves the point of a cylinder or cone along its axis, next to `p`.
inline void move_along_axis(Fitted_surface<>& s, const Double_3& p)
{
  if (s.kind != Surface_kind::CYLINDER && s.kind != Surface_kind::CONE)
    return;
  const double z = dot(p - s.point, s.direction);
  s.point = s.point + z * s.direction;
  s.radius += s.kind == Surface_kind::CONE ? z * std::tan(s.angle) : 0;
}

/// Fits a surface to points: Levenberg and Marquardt's method for the sum of squared distances,
/// from the initial values in the surface. One parametrization serves all kinds: 3 numbers move the
/// point, 2 tilt the axis, 2 change the shape; those that a kind does not have get zero derivatives
/// and are left.
class Surface_fitter
{
public:
  /// \param stop the root mean square distance below which the fit is good enough
  /// \param weights of the points; empty: all are 1
  Surface_fitter(const std::vector<Double_3>& points, double stop, std::vector<double> weights = {})
    : m_points(points)
    , m_weights(std::move(weights))
    , m_stop(stop)
  {
    for (std::size_t i = 0; i < points.size(); ++i) {
      m_center = m_center + points[i];
      m_weight += weight(i);
    }
    m_center = (1.0 / double(points.size())) * m_center;
    for (const Double_3& p : points)
      m_size = (std::max)(m_size, norm(p - m_center));
  }

  /// Returns the root mean square distance, infinity if the fit leads to no surface.
  /// \param slow_iterations in a row, of which none improves much, after which the fit ends
  double operator()(Fitted_surface<>& s, int iterations = 15, int slow_iterations = 3) const
  {
    anchor(s);
    Normal_equations best = equations(s);
    double damping = 1e-3;
    int slow = 0;
    for (int i = 0; i < iterations && rms(best) > m_stop && slow < slow_iterations; ++i) {
      const Fitted_surface<> next = moved(s, step(best, damping));
      const Normal_equations e = equations(next);
      if (e.cost < best.cost) {
        slow = e.cost > 0.8 * best.cost ? slow + 1 : 0;
        damping = (std::max)(1e-12, 0.05 * damping);
        s = next;
        best = e;
      } else {
        ++slow;
        damping = 10 * damping;
      }
    }
    return normalized(s) ? rms(best) : std::numeric_limits<double>::infinity();
  }

  double root_mean_square(const Fitted_surface<>& s) const
  {
    const Surface_distance distance(s);
    double sum = 0;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      const double d = distance(m_points[i]);
      sum += weight(i) * d * d;
    }
    return std::sqrt(sum / m_weight);
  }

private:
  using Vector = Eigen::Matrix<double, 7, 1, Eigen::DontAlign>;
  using Matrix = Eigen::Matrix<double, 7, 7, Eigen::DontAlign>;

  struct Normal_equations
  {
    Matrix a = Matrix::Zero();
    Vector b = Vector::Zero();
    double cost = 0;
  };

  double weight(std::size_t i) const { return m_weights.empty() ? 1 : m_weights[i]; }

  double rms(const Normal_equations& e) const { return std::sqrt(e.cost / m_weight); }

  /// Moves the point of a plane, cylinder or cone next to the points; the fit is well conditioned
  /// there.
  void anchor(Fitted_surface<>& s) const
  {
    if (s.kind == Surface_kind::PLANE)
      s.point = m_center - dot(m_center - s.point, s.direction) * s.direction;
    else
      move_along_axis(s, m_center);
  }

  Normal_equations equations(const Fitted_surface<>& s) const
  {
    const Double_3 e1 = any_perpendicular(s.direction), e2 = cross(s.direction, e1);
    const bool slides = s.kind == Surface_kind::CONE || s.kind == Surface_kind::CYLINDER;
    const Surface_distance distance(s);
    Normal_equations result;
    for (std::size_t k = 0; k < m_points.size(); ++k) {
      const Meridian_point m = meridian_point(s, m_points[k]);
      const Profile f = distance.profile(m.r, m.z);
      const double x = dot(m.outward, e1), y = dot(m.outward, e2),
                   tilt = f.by_z * m.r - f.by_r * m.z;
      Vector row;
      row << -f.by_r * x, -f.by_r * y, slides ? 0 : -f.by_z, tilt * x, tilt * y, f.by_radius,
        f.by_second;
      const double w = weight(k);
      for (int i = 0; i < 7; ++i) {
        result.b[i] += w * row[i] * f.value;
        for (int j = 0; j <= i; ++j)
          result.a(i, j) += w * row[i] * row[j];
      }
      result.cost += w * f.value * f.value;
    }
    return result;
  }

  Vector step(const Normal_equations& e, double damping) const
  {
    Matrix a = e.a;
    for (int i = 0; i < 7; ++i)
      a(i, i) = a(i, i) * (1 + damping) + (a(i, i) > 0 ? 0 : 1);
    return solve_positive_definite(a, Vector(-e.b));
  }

  static Fitted_surface<> moved(const Fitted_surface<>& s, const Vector& d)
  {
    const Double_3 e1 = any_perpendicular(s.direction), e2 = cross(s.direction, e1);
    Fitted_surface<> result = s;
    result.point = s.point + d[0] * e1 + d[1] * e2 + d[2] * s.direction;
    const Double_3 a = s.direction + d[3] * e1 + d[4] * e2;
    result.direction = (1 / norm(a)) * a;
    result.radius = s.radius + d[5];
    (s.kind == Surface_kind::CONE ? result.angle : result.minor_radius) += d[6];
    return result;
  }

  /// Brings the parameters into their ranges. Returns whether the surface is one.
  bool normalized(Fitted_surface<>& s) const
  {
    if (s.kind == Surface_kind::CONE && s.angle < 0) {
      s.angle = -s.angle;
      s.direction = -1.0 * s.direction;
    }
    const bool cone = s.kind != Surface_kind::CONE || (s.angle > 1e-4 && s.angle < 1.5);
    const bool torus = s.kind != Surface_kind::TORUS ||
                       (s.minor_radius > 0 && s.radius > 0.01 * s.minor_radius &&
                        s.minor_radius < 50 * m_size);
    const bool size = s.kind == Surface_kind::PLANE || (s.radius > 0 && s.radius < 100 * m_size);
    return is_finite(s.point) && is_finite(s.direction) && (size || s.kind == Surface_kind::CONE) &&
           cone && torus;
  }

  const std::vector<Double_3>& m_points;
  const std::vector<double> m_weights;
  double m_stop;
  Double_3 m_center{0, 0, 0};
  double m_size = 0, m_weight = 0;
};

/// At most so many of several points, or of what belongs to them, at multiples of the golden ratio:
/// in the order of vertices, every second or third one may lie on one circle.
template <typename T>
std::vector<T> evenly_spread(const std::vector<T>& points, std::size_t most)
{
  constexpr double golden = 0.618033988749895;
  if (points.size() <= most)
    return points;
  std::vector<T> result;
  for (std::size_t i = 0; i < most; ++i) {
    const double x = golden * double(i);
    result.push_back(points[std::size_t((x - std::floor(x)) * double(points.size()))]);
  }
  return result;
}

/// Fits a surface to some of the points, from the values that it has. They stay if those found are
/// not within the tolerance.
/// \param stop see `Surface_fitter`
inline void refine_surface(Fitted_surface<>& s, const std::vector<Double_3>& points,
                           double tolerance, double stop)
{
  const std::vector<Double_3> sample = evenly_spread(points, 300);
  if (int(sample.size()) < degrees_of_freedom(s.kind))
    return;
  Fitted_surface<> better = s;
  if (Surface_fitter(sample, stop)(better, 8) <= tolerance)
    s = better;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIT_SURFACE_H
