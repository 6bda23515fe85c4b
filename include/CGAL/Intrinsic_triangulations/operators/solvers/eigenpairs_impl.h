// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_EIGENPAIRS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_EIGENPAIRS_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/eigenpairs.h>

#include <Eigen/Eigenvalues>
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// What Spectra asks of an operator, y = (a - shift m)^-1 x, with a factorization that was made.
class Shifted_inverse {
public:
  using Scalar = double; // named by Spectra

  explicit Shifted_inverse(const Eigen::SparseMatrix<double>& shifted) : factorization_(shifted) {}
  Eigen::Index rows() const { return factorization_.size(); }
  Eigen::Index cols() const { return factorization_.size(); }
  void set_shift(double) {}
  void perform_op(const double* x, double* y) const {
    Eigen::Map<Eigen::VectorXd>(y, rows()) =
        factorization_.solve(Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(x, rows())));
  }

private:
  Cholesky_factorization<double> factorization_;
};

inline Eigenpairs dense_eigenpairs(const Eigen::SparseMatrix<double>& a,
                                   const Eigen::SparseMatrix<double>& m, Eigen::Index count) {
  const Eigen::MatrixXd dense(m);
  if (Eigen::LLT<Eigen::MatrixXd>(dense).info() != Eigen::Success)
    throw std::runtime_error("the mass matrix is not positive definite");
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(Eigen::MatrixXd(a), dense);
  return {solver.eigenvalues().head(count), solver.eigenvectors().leftCols(count)};
}

// Inverted below zero by far less than the first frequency of a mesh, trace(a) / trace(m) / size or so, and by enough that rounding
// leaves the matrix definite: its smallest eigenvalue is the shift, its condition about the square of the size.
inline double spectral_shift(const Eigen::SparseMatrix<double>& a,
                             const Eigen::SparseMatrix<double>& m) {
  const double size = static_cast<double>(a.rows());
  return a.diagonal().sum() / m.diagonal().sum() / (size * size) +
         std::numeric_limits<double>::min();
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigenpairs
smallest_eigenpairs(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& m,
                    Eigen::Index count) {
  const Eigen::Index size = a.rows();
  if (a.cols() != size || m.rows() != size || m.cols() != size)
    throw std::invalid_argument("both matrices must be square and of one size");
  if (count < 0 || count > size)
    throw std::invalid_argument("a matrix with " + std::to_string(size) + " rows has not " +
                                std::to_string(count) + " eigenvalues");
  constexpr Eigen::Index small =
      64; // a dense method is faster, and needs no room for a Krylov space
  const Eigen::Index space = std::min(size, std::max<Eigen::Index>(2 * count + 1, 20));
  if (size <= small || space == size) return internal::dense_eigenpairs(a, m, count);
  const double shift = internal::spectral_shift(a, m);
  internal::Shifted_inverse inverse(a + shift * m);
  Spectra::SparseSymMatProd<double> mass(m);
  Spectra::SymGEigsShiftSolver<internal::Shifted_inverse, Spectra::SparseSymMatProd<double>,
                               Spectra::GEigsMode::ShiftInvert>
      solver(inverse, mass, count, space, -shift);
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-13, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw std::runtime_error("the eigenvalues have not converged; ask for others, or a finer mesh");
  return {solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_EIGENPAIRS_IMPL_H
