// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_CURVATURES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_CURVATURES_H

#include <CGAL/Region_segmentation/internal/faces/Chord_normals.h>
#include <CGAL/Region_segmentation/internal/faces/Shared_side.h>
#include <CGAL/Region_segmentation/internal/faces/fit_surface.h>
#include <CGAL/Region_segmentation/internal/faces/solve_positive_definite.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The curvature of the surface in each of some faces of its tessellation, and how much it jumps
/// from one face to the next.
class Face_curvatures
{
public:
  using Index = Surface::Index;

  struct Jump
  {
    double difference; ///< of the normal curvatures orthogonal to the edge, lower face - higher one
    double scale;      ///< that a difference between two faces of the part is compared with
  };

  Face_curvatures(const Face_search& search, const std::vector<std::uint8_t>& is_free)
    : m_surface(search.surface)
    , m_numbers(m_surface.number_of_faces(), 0)
  {
    const Chord_normals normals(search, is_free);
    for (std::size_t f = 0; f < m_numbers.size(); ++f)
      if (is_free[f]) {
        m_numbers[f] = Index(m_tensors.size());
        m_tensors.push_back(m_surface.is_degenerate(f) ? Tensor() : tensor(normals, f));
      }
  }

  /// Across an adjacency of two of the faces.
  Jump operator()(std::size_t adjacency) const
  {
    constexpr double of_norm = 0.05, of_error = 25, of_size = 1;
    const Index f = m_surface.lower_face(adjacency), g = m_surface.higher_face(adjacency);
    const Tensor &s = m_tensors[m_numbers[f]], &t = m_tensors[m_numbers[g]];
    const Double_3 along = Shared_side(m_surface, f, g).along;
    const double cf = s.across(along), cg = t.across(along);
    return {cf - cg, (std::max)(std::fabs(cf), std::fabs(cg)) +
                       of_norm * (std::max)(s.norm(), t.norm()) + of_error * (s.error + t.error) +
                       of_size / m_surface.length_unit()};
  }

private:
  /// The symmetric tensor whose product with a step is the change of the normal, in a frame of the
  /// tangent plane.
  struct Tensor
  {
    Double_3 axes[2] = {{0, 0, 0}, {0, 0, 0}};
    double xx = 0, xy = 0, yy = 0;
    double error = 0; ///< of the curvature along edges

    double norm() const { return std::sqrt(xx * xx + 2 * xy * xy + yy * yy); }
    /// The normal curvature orthogonal to a direction in the tangent plane.
    double across(const Double_3& along) const
    {
      const double x = dot(along, axes[0]), y = dot(along, axes[1]), squared = x * x + y * y;
      return squared > 0 ? (xx * y * y - 2 * xy * x * y + yy * x * x) / squared : 0;
    }
  };

  /// Least squares over the edges.
  Tensor tensor(const Chord_normals& normals, std::size_t f) const
  {
    using Vector = Eigen::Matrix<double, 3, 1, Eigen::DontAlign>;
    constexpr double regular = 1e-6;
    const std::size_t n = m_surface.number_of_corners(f);
    Double_3 normal{0, 0, 0};
    for (std::size_t i = 0; i < n; ++i)
      normal = normal + normals(f, i);
    const double length = Region_segmentation::norm(normal);
    Tensor t;
    if (!(length > 0))
      return t;
    t.axes[0] = any_perpendicular((1 / length) * normal);
    t.axes[1] = cross((1 / length) * normal, t.axes[0]);
    Eigen::Matrix<double, 3, 3, Eigen::DontAlign> a = Eigen::Matrix3d::Zero();
    Vector b = Vector::Zero();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const Double_3 d = m_surface.point(m_surface.corner(f, j)) -
                         m_surface.point(m_surface.corner(f, i));
      const Double_3 turn = normals(f, j) - normals(f, i);
      const double squared = squared_norm(d);
      if (!(squared > 0))
        continue;
      t.error = (std::max)(t.error, std::fabs(dot(normals(f, i) + normals(f, j), d)) / squared);
      const double x = dot(d, t.axes[0]), y = dot(d, t.axes[1]);
      const Vector rows[] = {Vector(x, y, 0), Vector(0, x, y)};
      for (int k = 0; k < 2; ++k) {
        a += rows[k] * rows[k].transpose();
        b += dot(turn, t.axes[k]) * rows[k];
      }
    }
    const double trace = a(0, 0) + a(1, 1) + a(2, 2);
    for (int k = 0; k < 3; ++k)
      a(k, k) += regular * trace;
    const Vector c = solve_positive_definite(a, b);
    t.xx = c[0];
    t.xy = c[1];
    t.yy = c[2];
    return t;
  }

  const Surface& m_surface;
  std::vector<Index> m_numbers; // of the faces, from 0
  std::vector<Tensor> m_tensors;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_CURVATURES_H
