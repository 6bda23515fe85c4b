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

// What Spectra asks of an operator, y = (a + s m)^-1 x, with a factorization that was made; eigenvectors that were found may be
// taken out, so that others come to the fore.
class Shifted_inverse {
public:
  using Scalar = double; // named by Spectra

  explicit Shifted_inverse(const Eigen::SparseMatrix<double>& shifted) : factorization_(shifted) {}
  Eigen::Index rows() const { return factorization_.size(); }
  Eigen::Index cols() const { return factorization_.size(); }
  void set_shift(double) {}
  void perform_op(const double* x, double* y) const {
    const Eigen::VectorXd v = Eigen::Map<const Eigen::VectorXd>(x, rows());
    Eigen::Map<Eigen::VectorXd> result(y, rows());
    result = factorization_.solve(v);
    if (out_.values.size() == 0) return;
    const Eigen::VectorXd parts = out_.vectors.transpose() * v;
    result -= out_.vectors * parts.cwiseProduct(out_.values);
  }
  // takes out pairs of `a x = lambda m x`
  void take_out(const Eigenpairs& pairs, double shift) {
    out_ = {(pairs.values.array() + shift).inverse(), pairs.vectors};
  }

private:
  Cholesky_factorization<double> factorization_;
  Eigenpairs out_{};
};

inline Eigenpairs lanczos_eigenpairs(Shifted_inverse& inverse,
                                     const Spectra::SparseSymMatProd<double>& mass,
                                     Eigen::Index count, double shift) {
  auto m = mass; // which Spectra takes as not constant
  const Eigen::Index space = std::min(inverse.rows(), std::max<Eigen::Index>(2 * count + 1, 20));
  Spectra::SymGEigsShiftSolver<Shifted_inverse, Spectra::SparseSymMatProd<double>,
                               Spectra::GEigsMode::ShiftInvert>
      solver(inverse, m, count, space, -shift);
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-13, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw std::runtime_error("the eigenvalues have not converged; ask for others, or a finer mesh");
  return {solver.eigenvalues(), solver.eigenvectors()};
}

// Puts one pair among others, the greatest of which is dropped.
inline void insert_pair(Eigenpairs& pairs, double value, const Eigen::VectorXd& vector) {
  Eigen::Index i = pairs.values.size() - 1;
  for (; i > 0 && pairs.values[i - 1] > value; --i) {
    pairs.values[i] = pairs.values[i - 1];
    pairs.vectors.col(i) = pairs.vectors.col(i - 1);
  }
  pairs.values[i] = value;
  pairs.vectors.col(i) = vector;
}

// From one vector Lanczos' method finds one eigenvector of each eigenvalue, and others by rounding alone: of a symmetric surface it misses
// some. They are found when the others are taken out.
inline void find_missed_pairs(Eigenpairs& pairs, Shifted_inverse& inverse,
                              const Spectra::SparseSymMatProd<double>& mass, double shift) {
  constexpr double equal = 1 - 1e-9;
  for (Eigen::Index i = 0; i < pairs.values.size(); ++i) {
    inverse.take_out(pairs, shift);
    const Eigenpairs next = lanczos_eigenpairs(inverse, mass, 1, shift);
    if (!(next.values[0] < equal * pairs.values[pairs.values.size() - 1])) return;
    insert_pair(pairs, next.values[0], next.vectors.col(0));
  }
}

// the row of the least diagonal entry
inline Eigen::Index least_diagonal(const Eigen::SparseMatrix<double>& m) {
  Eigen::Index row = 0;
  Eigen::VectorXd(m.diagonal()).minCoeff(&row);
  return row;
}

inline Eigenpairs dense_eigenpairs(const Eigen::SparseMatrix<double>& a,
                                   const Eigen::SparseMatrix<double>& m, Eigen::Index count) {
  const Eigen::MatrixXd dense(m);
  if (Eigen::LLT<Eigen::MatrixXd>(dense).info() != Eigen::Success)
    throw Indefinite_matrix(least_diagonal(m));
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
  constexpr Eigen::Index small = 64; // a dense method is faster
  if (count == 0) return {{}, Eigen::MatrixXd(size, 0)};
  if (size <= std::max(small, 2 * count + 1)) return internal::dense_eigenpairs(a, m, count);
  const double shift = internal::spectral_shift(a, m);
  internal::Shifted_inverse inverse(a + shift * m);
  const Spectra::SparseSymMatProd<double> mass(m);
  Eigenpairs pairs = internal::lanczos_eigenpairs(inverse, mass, count, shift);
  internal::find_missed_pairs(pairs, inverse, mass, shift);
  return pairs;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_EIGENPAIRS_IMPL_H
