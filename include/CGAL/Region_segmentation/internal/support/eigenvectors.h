// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_EIGENVECTORS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_EIGENVECTORS_H

#include <CGAL/Region_segmentation/internal/support/Second_moments.h>

#include <Eigen/Eigenvalues>

#include <array>

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

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_EIGENVECTORS_H
