// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_NORMALIZED_CUT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_NORMALIZED_CUT_H

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#if __has_include(<Spectra/SymEigsShiftSolver.h>)
#include <Spectra/MatOp/SparseSymShiftSolve.h>
#include <Spectra/SymEigsShiftSolver.h>
#define CGAL_REGION_SEGMENTATION_USE_SPECTRA
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

struct Eigenpairs
{
  Eigen::VectorXd values;  // in increasing order
  Eigen::MatrixXd vectors; // the columns, of length 1
};

inline Eigenpairs dense_lowest_eigenpairs(const Eigen::SparseMatrix<double>& matrix,
                                          Eigen::Index number)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{Eigen::MatrixXd(matrix)};
  return {solver.eigenvalues().head(number), solver.eigenvectors().leftCols(number)};
}

#ifdef CGAL_REGION_SEGMENTATION_USE_SPECTRA

/// If few of many eigenpairs are wanted: Lanczos on the inverse of the matrix plus 10^-4, always
/// from the same vector. Otherwise all, by Eigen: O(n^3).
struct Spectra_solver
{
  Eigenpairs operator()(const Eigen::SparseMatrix<double>& matrix, Eigen::Index number) const
  {
    constexpr Eigen::Index smallest_sparse = 64;
    const Eigen::Index n = matrix.rows(), basis = (std::max)(Eigen::Index(20), 2 * number + 1);
    if (n >= smallest_sparse && basis <= n / 2) {
      Spectra::SparseSymShiftSolve<double> inverse(matrix);
      Spectra::SymEigsShiftSolver<Spectra::SparseSymShiftSolve<double>> solver(inverse, number,
                                                                               basis, -1e-4);
      solver.init();
      solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-9); // values of the inverse
      if (solver.info() == Spectra::CompInfo::Successful)
        return {solver.eigenvalues().reverse(), solver.eigenvectors().rowwise().reverse()};
    }
    return dense_lowest_eigenpairs(matrix, number);
  }
};
using Eigen_solver = Spectra_solver;

#else

struct Dense_solver
{
  Eigenpairs operator()(const Eigen::SparseMatrix<double>& matrix, Eigen::Index number) const
  {
    return dense_lowest_eigenpairs(matrix, number);
  }
};
using Eigen_solver = Dense_solver;

#endif

/// An undirected edge of the graph that is cut.
struct Affinity
{
  std::size_t a, b;
  double value; // at least 0
};

/// The nodes of a graph as points, a row each, such that the squared distance of two is their
/// commute time in a random walk by the affinities, projected to the `number` lowest eigenvectors
/// of L y = lambda D y except the constant one, which every node shares; L the Laplacian, D the
/// degrees. A node without affinities is at the origin.
///
/// \tparam Solver gives the eigenpairs of lowest value of a symmetric, positive semidefinite matrix
template <typename Solver>
Eigen::MatrixXd commute_time_embedding(std::size_t number_of_nodes,
                                       const std::vector<Affinity>& affinities, std::size_t number)
{
  const auto n = Eigen::Index(number_of_nodes);
  if (n == 0)
    return Eigen::MatrixXd(0, 0);
  Eigen::VectorXd roots = Eigen::VectorXd::Zero(n); // of the degrees; 1 of a node without
                                                    // affinities
  for (const Affinity& e : affinities) {
    roots[Eigen::Index(e.a)] += e.value;
    roots[Eigen::Index(e.b)] += e.value;
  }
  const Eigen::VectorXd is_alone = (roots.array() <= 0).cast<double>();
  roots = (roots + is_alone).array().sqrt();

  std::vector<Eigen::Triplet<double, Eigen::Index>> entries;
  for (Eigen::Index i = 0; i < n; ++i)
    entries.emplace_back(i, i, 1);
  for (const Affinity& e : affinities) {
    const auto a = Eigen::Index(e.a), b = Eigen::Index(e.b);
    entries.emplace_back(a, b, -e.value / roots[a] / roots[b]);
    entries.emplace_back(b, a, -e.value / roots[a] / roots[b]);
  }
  Eigen::SparseMatrix<double> laplacian(n, n); // D^-1/2 L D^-1/2
  laplacian.setFromTriplets(entries.begin(), entries.end());

  const Eigenpairs pairs = Solver()(laplacian, (std::min)(Eigen::Index(number), n));
  Eigen::MatrixXd points = roots.cwiseInverse().asDiagonal() * pairs.vectors;
  constexpr double smallest = 1e-7; // of a graph in several pieces; they end far from each other
  for (Eigen::Index j = 0; j < points.cols(); ++j)
    points.col(j) /= std::sqrt((std::max)(pairs.values[j], smallest));
  return points;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_NORMALIZED_CUT_H
