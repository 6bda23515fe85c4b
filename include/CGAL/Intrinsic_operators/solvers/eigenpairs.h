// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>

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
  Status status = Status::done; ///< `cancelled` by the caller: there are none then
};

namespace internal {
Eigenpairs smallest_eigenpairs(const Eigen::SparseMatrix<double>& a,
                               const Eigen::SparseMatrix<double>& m, Eigen::Index count,
                               const std::function<bool(std::size_t)>& progress);
} // namespace internal

/*!
\brief computes the smallest eigenvalues of `a x = lambda m x`, and their eigenvectors, by the
Lanczos method of Spectra, inverted near zero, several times until none is missing of eigenvalues
that are several times there.

With `a` the cotangent Laplacian and `m` a mass matrix they are the squared frequencies and modes of
the surface: zero once for each of its components, with constants there. Where `m` is diagonal and
rows of `a` sum to zero, as of the cotangent Laplacian, the matrix is factored without subtraction
(`Laplacian_factorization`), and the shift is made no greater than the smallest frequencies: values
are right to rounding whatever the weights of slivers are. Matrices of up to 64 rows, or of which
half of the eigenvalues are asked for, are solved densely, to rounding of the greatest eigenvalue.
Of a matrix without entries, as of isolated vertices, all eigenvalues are zero, with any vectors.
\param a the matrix \pre symmetric and positive semidefinite
\param m the mass matrix \pre symmetric and positive definite; isolated vertices have no mass
\param count how many, at most the size of the matrix
\param np optional named parameters:
  - `visitor(v)`: `v.progress(n)` is called before each solution with a factored matrix, those that
    look for the shift included, with the number of those before, a `std::size_t`, and returns
    whether to go on. Small matrices are solved without a call.
\return the pairs; the residual of each, \f$|a x - \lambda m x|\f$, is that of rounding
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
                               const NP& np = parameters::default_values()) {
  internal::expect_names<internal::tags::visitor>(np);
  return internal::smallest_eigenpairs(a, m, count, internal::progress_of(np));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_EIGENPAIRS_H
