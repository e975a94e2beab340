// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_SOLVE_POSITIVE_DEFINITE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_SOLVE_POSITIVE_DEFINITE_H

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Solves a x = b by the decomposition a = l d l^T, without pivoting; only the lower triangle of
/// `a` is read. Unknowns that the equations do not determine are 0. Eigen's decompositions sum in
/// the order of the vector unit, and fuse products and sums where it can: their last bits, and
/// through them faces, would depend on the processor.
template <typename Matrix, typename Vector>
Vector solve_positive_definite(Matrix a, Vector b)
{
  const auto quotient = [](double x, double d) { return d > 0 ? x / d : 0; };
  const int n = int(b.size());
  for (int j = 0; j < n; ++j) // below the diagonal l, on it d
    for (int i = j; i < n; ++i) {
      for (int k = 0; k < j; ++k)
        a(i, j) -= a(i, k) * a(j, k) * a(k, k);
      if (i > j)
        a(i, j) = quotient(a(i, j), a(j, j));
    }
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < i; ++k)
      b[i] -= a(i, k) * b[k];
  for (int i = n - 1; i >= 0; --i) {
    b[i] = quotient(b[i], a(i, i));
    for (int k = i + 1; k < n; ++k)
      b[i] -= a(k, i) * b[k];
  }
  return b;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_SOLVE_POSITIVE_DEFINITE_H
