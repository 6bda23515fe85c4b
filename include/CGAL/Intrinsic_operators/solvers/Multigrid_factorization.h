// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_FACTORIZATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_FACTORIZATION_H

#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <concepts>
#include <memory>
#include <stdexcept>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
template <class Scalar>
struct Multigrid;
} // namespace internal

/// How an iteration for some right sides ended.
struct Iterations {
  Status status = Status::done; ///< `done`, or `cap` where a residual is above the tolerance
  int most = 0;                 ///< the greatest number of steps for a right side
  /// the greatest one, \f$|b - a x| / |b|\f$, computed at the end; of the right side without the
  /// constants that are projected out
  double residual = 0;
};

/// An iteration ended before its residual was as small as asked.
class No_convergence : public std::runtime_error {
public:
  /// constructs an error from how the iteration ended.
  explicit No_convergence(const Iterations& iterations);
  /// returns how it ended.
  const Iterations& iterations() const { return iterations_; }

private:
  Iterations iterations_;
};

/*!
\brief solves with a positive definite matrix by conjugate gradients, preconditioned by multigrid. A
model of `Factorization` for matrices whose factor does not fit into memory, or for few right sides.

It groups unknowns that strong entries connect, smooths the groups once, and repeats that for the
matrix between groups (smoothed aggregation: Vanek, Mandel and Brezina 1996). Memory and, for
Laplacians of Delaunay triangulations, time are linear in the number of rows. For complex matrices
groups turn with the entries, so that connection Laplacians converge as well.

Solutions have a small residual, not a small error in each entry: where they are smaller than the
greatest one by the tolerance, they have no digits. The flow of heat needs
`Laplacian_factorization` for that reason.

If rows of a real matrix sum to zero in a component, as those of a Laplacian without masses,
constants are projected out there: right sides must sum to zero, and so do solutions.

Copies share everything. Different threads may solve at once.

\tparam Scalar `double` for symmetric matrices, `std::complex<double>` for Hermitian ones
*/
template <internal::Matrix_number Scalar>
class Multigrid_factorization {
public:
  using Matrix = Eigen::SparseMatrix<Scalar>; ///< what is prepared
  using Vectors =
      Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>; ///< right sides, a column each

  /*!
  \brief prepares a matrix.
  \param a the matrix; only its lower triangle is read
  \param tolerance the greatest relative residual of solutions
  \throws std::invalid_argument if it is not square, an entry is not finite, or the tolerance is not
    between 1e-14 and 1
  \throws Indefinite_matrix if a diagonal entry is not positive, or the matrix of the coarsest
    groups is not definite; `solve()` finds other indefinite matrices, if its right side shows them
  \complexity linear in the number of entries
  */
  explicit Multigrid_factorization(const Matrix& a, double tolerance = 1e-10);

  /*!
  \brief prepares L + D with the Laplacian L of a graph and a diagonal D, as
  `Laplacian_factorization`. So D is not lost beside large weights, as it is in their sum.
  \param laplacian the matrix L; only entries below its diagonal are read
  \param diagonal D, a number per row
  \param tolerance the greatest relative residual of solutions
  \throws std::invalid_argument,Indefinite_matrix as the other constructor, or if sizes do not fit
  \complexity linear in the number of entries
  */
  Multigrid_factorization(const Matrix& laplacian, const Eigen::VectorXd& diagonal,
                          double tolerance = 1e-10) requires std::same_as<Scalar, double>;

  /// returns the number of rows.
  Eigen::Index size() const;

  /*!
  \brief solves `a x = b`.
  \param b right sides, a column each
  \return the solutions, a column each
  \throws std::invalid_argument if b does not have a row per row of the matrix, is not finite, or
    does not sum to zero in a component on which constants are in the kernel
  \throws Indefinite_matrix if the iteration finds that the matrix is not positive definite
  \throws No_convergence if a residual remains above the tolerance
  \complexity linear in the number of entries for each step and column
  */
  Vectors solve(const Vectors& b) const;

  /*!
  \brief solves `a x = b` as far as the iteration gets.
  \param b right sides, a column each
  \param iterations becomes how it ended
  \return the solutions, a column each, also where a residual remains above the tolerance
  \throws std::invalid_argument,Indefinite_matrix as the other overload
  */
  Vectors solve(const Vectors& b, Iterations& iterations) const;

private:
  std::shared_ptr<const internal::Multigrid<Scalar>> multigrid_;
};

/// constructs from a matrix without naming its numbers.
template <internal::Matrix_number Scalar>
Multigrid_factorization(const Eigen::SparseMatrix<Scalar>&, double = 1e-10)
    -> Multigrid_factorization<Scalar>;

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_FACTORIZATION_H
