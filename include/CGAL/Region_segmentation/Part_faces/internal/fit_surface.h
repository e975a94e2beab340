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

/// The decomposition a = l d l^T of a symmetric matrix, without pivoting; only the lower triangle
/// is read. Unknowns that those before them determine are 0. Eigen's decompositions sum in the
/// order of the vector unit, and fuse products and sums where it can: their last bits, and through
/// them faces, would depend on the processor.
template <typename Matrix>
class Positive_definite
{
public:
  explicit Positive_definite(const Matrix& a)
    : m_factors(a)
  {
    constexpr double rounding = 1e-13;
    const int n = int(a.rows());
    for (int j = 0; j < n; ++j) // below the diagonal l, on it 1 / d
      for (int i = j; i < n; ++i) {
        double& x = m_factors(i, j);
        for (int k = 0; k < j; ++k)
          x -= m_factors(i, k) * m_factors(j, k) * m_pivots[k];
        if (i == j) {
          m_pivots[j] = x > rounding * a(j, j) ? x : 0;
          x = m_pivots[j] > 0 ? 1 / x : 0;
        } else
          x *= m_factors(j, j);
      }
  }

  /// The solution x of a x = b.
  template <typename Vector>
  Vector solve(Vector b) const
  {
    const int n = int(b.size());
    forward(b);
    for (int i = n - 1; i >= 0; --i) {
      b[i] *= m_factors(i, i);
      for (int k = i + 1; k < n; ++k)
        b[i] -= m_factors(k, i) * b[k];
    }
    return b;
  }

  /// b^T a^-1 b.
  template <typename Vector>
  double inverse_form(Vector b) const
  {
    forward(b);
    double sum = 0;
    for (int i = 0; i < int(b.size()); ++i)
      sum += b[i] * b[i] * m_factors(i, i);
    return sum;
  }

private:
  template <typename Vector>
  void forward(Vector& b) const
  {
    for (int i = 0; i < int(b.size()); ++i)
      for (int k = 0; k < i; ++k)
        b[i] -= m_factors(i, k) * b[k];
  }

  Matrix m_factors;
  double m_pivots[Matrix::RowsAtCompileTime] = {};
};

/// Solves a x = b, see `Positive_definite`.
template <typename Matrix, typename Vector>
Vector solve_positive_definite(const Matrix& a, const Vector& b)
{
  return Positive_definite<Matrix>(a).solve(b);
}

inline constexpr Surface_kind kinds_of_surfaces[] = {Surface_kind::PLANE, Surface_kind::CYLINDER,
                                                     Surface_kind::CONE, Surface_kind::SPHERE,
                                                     Surface_kind::TORUS};

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

using Surface_vector = Eigen::Matrix<double, 7, 1, Eigen::DontAlign>;
using Surface_matrix = Eigen::Matrix<double, 7, 7, Eigen::DontAlign>;

/// The distance of a point to a surface, and its derivatives by what a fit changes. One
/// parametrization serves all kinds: 3 numbers move the point, 2 tilt the axis, 2 change the shape;
/// the derivatives by those that a kind does not have are 0. It refers to the surface.
class Surface_derivatives
{
public:
  explicit Surface_derivatives(const Fitted_surface<>& s)
    : m_surface(s)
    , m_distance(s)
    , m_e1(any_perpendicular(s.direction))
    , m_e2(cross(s.direction, m_e1))
    , m_slides(s.kind == Surface_kind::CONE || s.kind == Surface_kind::CYLINDER)
  {}

  double operator()(const Double_3& p, Surface_vector& row) const
  {
    const Meridian_point m = meridian_point(m_surface, p);
    const Profile f = m_distance.profile(m.r, m.z);
    const double x = dot(m.outward, m_e1), y = dot(m.outward, m_e2),
                 tilt = f.by_z * m.r - f.by_r * m.z;
    row << -f.by_r * x, -f.by_r * y, m_slides ? 0 : -f.by_z, tilt * x, tilt * y, f.by_radius,
      f.by_second;
    return f.value;
  }

  Fitted_surface<> moved(const Surface_vector& d) const
  {
    Fitted_surface<> result = m_surface;
    result.point = m_surface.point + d[0] * m_e1 + d[1] * m_e2 + d[2] * m_surface.direction;
    const Double_3 a = m_surface.direction + d[3] * m_e1 + d[4] * m_e2;
    result.direction = (1 / norm(a)) * a;
    result.radius = m_surface.radius + d[5];
    (m_surface.kind == Surface_kind::CONE ? result.angle : result.minor_radius) += d[6];
    return result;
  }

private:
  const Fitted_surface<>& m_surface;
  Surface_distance m_distance;
  Double_3 m_e1, m_e2;
  bool m_slides;
};

/// Fits a surface to points: Levenberg and Marquardt's method for the sum of squared distances,
/// from the initial values in the surface.
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
  /// \param wanted the greatest distance that is of use: the fit ends early if its linearization
  ///        tells that it stays far above
  double operator()(Fitted_surface<>& s, int iterations, int slow_iterations = 3,
                    double wanted = std::numeric_limits<double>::infinity()) const
  {
    constexpr int first_foreseen = 2; // iteration
    constexpr double far_above = 100;
    anchor(s);
    Normal_equations best = equations(s);
    double damping = 1e-3;
    int slow = 0;
    for (int i = 0; i < iterations && rms(best.cost) > m_stop && slow < slow_iterations; ++i) {
      const Positive_definite<Surface_matrix> matrix(damped(best.a, damping));
      if (i >= first_foreseen && rms(best.cost - matrix.inverse_form(best.b)) > far_above * wanted)
        break;
      const Fitted_surface<> next = Surface_derivatives(s).moved(
        matrix.solve(Surface_vector(-best.b)));
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
    return normalized(s) ? rms(best.cost) : std::numeric_limits<double>::infinity();
  }

  /// The sum of the products of the derivatives.
  Surface_matrix information(const Fitted_surface<>& s) const { return equations(s).a; }

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
  struct Normal_equations
  {
    Surface_matrix a = Surface_matrix::Zero();
    Surface_vector b = Surface_vector::Zero();
    double cost = 0;
  };

  double weight(std::size_t i) const { return m_weights.empty() ? 1 : m_weights[i]; }

  double rms(double cost) const { return std::sqrt(cost / m_weight); }

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
    const Surface_derivatives derivatives(s);
    Normal_equations result;
    Surface_vector row;
    for (std::size_t k = 0; k < m_points.size(); ++k) {
      const double distance = derivatives(m_points[k], row), w = weight(k);
      for (int i = 0; i < 7; ++i) {
        result.b[i] += w * row[i] * distance;
        for (int j = 0; j <= i; ++j)
          result.a(i, j) += w * row[i] * row[j];
      }
      result.cost += w * distance * distance;
    }
    return result;
  }

  static Surface_matrix damped(Surface_matrix a, double damping)
  {
    for (int i = 0; i < 7; ++i)
      a(i, i) = a(i, i) * (1 + damping) + (a(i, i) > 0 ? 0 : 1);
    return a;
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

/// The i-th of numbers below n that are spread evenly however many are taken, at multiples of the
/// golden ratio: in the order of vertices, every second or third one may lie on one circle.
inline std::size_t evenly_spread_index(std::size_t i, std::size_t n)
{
  constexpr double golden = 0.618033988749895;
  const double x = golden * double(i);
  return std::size_t((x - std::floor(x)) * double(n));
}

/// At most so many of several points, or of what belongs to them.
template <typename T>
std::vector<T> evenly_spread(const std::vector<T>& points, std::size_t most)
{
  if (points.size() <= most)
    return points;
  std::vector<T> result;
  for (std::size_t i = 0; i < most; ++i)
    result.push_back(points[evenly_spread_index(i, points.size())]);
  return result;
}

/// Of a large face, so many points are fitted.
inline constexpr std::size_t most_fitted_points = 300;
/// A surface that fits nearly needs so many iterations.
inline constexpr int few_iterations = 8;

/// Fits a surface to points, from the values that it has. Returns whether it led to a surface.
/// \param stop see `Surface_fitter`
inline bool refine_surface(Fitted_surface<>& s, const std::vector<Double_3>& points, double stop)
{
  const std::vector<Double_3> sample = evenly_spread(points, most_fitted_points);
  return std::isfinite(Surface_fitter(sample, stop)(s, few_iterations));
}

/// Whether points are on a surface: within the prediction interval of its fit, which widens away
/// from the points that were fitted. It refers to the surface.
class Surface_prediction
{
public:
  /// \param half_width of the interval at points that determine the surface well
  Surface_prediction(const Fitted_surface<>& s, const Surface_fitter& fitter, double half_width)
    : m_derivatives(s)
    , m_information(fitter.information(s))
    , m_half_width(half_width)
  {}

  bool operator()(const Double_3& p) const
  {
    constexpr double most_leverage = 30;
    Surface_vector row;
    const double distance = std::fabs(m_derivatives(p, row));
    if (!(distance > m_half_width))
      return true;
    const double leverage = (std::min)(m_information.inverse_form(row), most_leverage);
    return distance <= m_half_width * std::sqrt(1 + leverage);
  }

private:
  Surface_derivatives m_derivatives;
  Positive_definite<Surface_matrix> m_information;
  double m_half_width;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIT_SURFACE_H
