// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_H

#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <functional>

namespace CGAL::Intrinsic_triangulations {

/// Eigenvalues, and their eigenvectors.
struct Eigenpairs {
  Eigen::VectorXd values; ///< the eigenvalues, in ascending order
  Eigen::MatrixXd
      vectors; ///< an eigenvector per column, orthonormal in the inner product of the mass matrix
  Status status = Status::done; ///< `cancelled` by the caller: then there are no pairs
};

namespace internal {
Eigenpairs smallest_eigenpairs(const Eigen::SparseMatrix<double>& a,
                               const Eigen::SparseMatrix<double>& m, Eigen::Index count,
                               Linear_solver solver,
                               const std::function<bool(std::size_t)>& progress);
} // namespace internal

/*!
\brief computes the smallest eigenvalues of `a x = lambda m x`, and their eigenvectors, by the
Lanczos method of Spectra, inverted near zero. It repeats the method until no multiple eigenvalue
misses a vector.

With `a` the cotangent Laplacian and `m` a mass matrix they are the squared frequencies and modes of
the surface: zero once for each of its components, with constants there. If `m` is diagonal and rows
of `a` sum to zero, as for the cotangent Laplacian, the matrix is factored without subtraction
(`Laplacian_factorization`), with a shift no greater than the smallest frequencies: values are right
up to rounding, also with slivers. Small matrices (up to 64 rows), or if `count` is at least half of
the rows, are solved densely, up to rounding of the greatest eigenvalue. If `a` is zero, as for
isolated vertices, all eigenvalues are zero and vectors are arbitrary.

An iterative solver does without a factor: a block of vectors improves by cycles of multigrid
(LOBPCG: Knyazev 2001). Values are right up to rounding, and the residual of each vector is at most
1e-8 \f$|\lambda m x|\f$, or rounding. Memory is that of up to nine blocks of vectors, each with a
quarter more vectors than pairs, and at least four more. If you ask for more than a sixteenth of all
pairs, a factor takes less memory, and is used. Pairs take dozens of solutions, so that a factor is
faster where memory suffices: `automatic` iterates beyond five million rows only, and factors after
all if that does not converge.
\param a the matrix \pre symmetric and positive semidefinite
\param m the mass matrix \pre symmetric and positive definite; isolated vertices have no mass
\param count how many, at most the size of the matrix
\param solver how
\param np optional named parameters:
  - `visitor(v)`: `v.progress(n)` is called before each solution with a factored matrix (also in the
    search of the shift), or before each cycle, with the number of previous ones of both, a
    `std::size_t`; it returns whether to go on. Dense solutions do not call it.
\return the pairs; the residual of each, \f$|a x - \lambda m x|\f$, is due to rounding only if the
  solver is direct
\throws std::invalid_argument if sizes do not fit
\throws Indefinite_matrix if a matrix is not definite up to rounding
\throws std::runtime_error if the method does not converge within its cap of restarts, or a residual
  is more than rounding
\complexity that of a factorization of `a`, and of some solutions for each pair; small matrices are
  solved densely
*/
template <NamedParameters NP = parameters::Parameters<>>
Eigenpairs smallest_eigenpairs(const Eigen::SparseMatrix<double>& a,
                               const Eigen::SparseMatrix<double>& m, Eigen::Index count,
                               Linear_solver solver, const NP& np = parameters::default_values()) {
  internal::expect_names<internal::tags::visitor>(np);
  return internal::smallest_eigenpairs(a, m, count, solver, internal::progress_of(np));
}

/// computes them with the solver that `solver_for()` chooses; see above.
template <NamedParameters NP = parameters::Parameters<>>
Eigenpairs smallest_eigenpairs(const Eigen::SparseMatrix<double>& a,
                               const Eigen::SparseMatrix<double>& m, Eigen::Index count,
                               const NP& np = parameters::default_values()) {
  return smallest_eigenpairs(a, m, count, Linear_solver::automatic, np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_H
