// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_FIXED_VALUES_SOLVER_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_FIXED_VALUES_SOLVER_H

#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief solves symmetric linear problems `a x = b` with given values in some rows (Dirichlet
conditions), which are eliminated:

    A_ff x_f = b_f - A_fc x_c

with f the free rows and c the fixed ones, in which the equations do not hold. The matrix A_ff is
factored once; then right sides and values may change. Without fixed border rows, a cotangent
Laplacian has its natural border condition (Neumann).

With `a` the cotangent Laplacian and `b` zero, x is the harmonic function with these values; with
`b` the mass matrix times f, the solution of a Poisson problem. With the rows of
`rows_with_constant_kernel()` fixed at zero, it gives one solution; others differ by a constant per
component. The Laplacian of a graph without negative weights is factored without subtraction, see
`Laplacian_factorization`: it stays definite, and solutions accurate, for all such weights. If
rounding explains all row sums of a component, they count as zero. With negative weights, as in
squares of Laplacians, the accuracy is that of a Cholesky factorization. Rows are those of vertices,
`t.input_vertex(v)`, inserted ones included.
*/
class Fixed_values_solver {
public:
  /*!
  \brief factors the free part of a matrix.
  \param a the matrix, both triangles of it \pre definite on the free rows: positive, or negative
  \param rows the fixed rows, in any order, repeated or not
  \param solver how to solve for the free rows; `automatic`: for any number of right sides
  \throws std::invalid_argument if the matrix is not square, finite and symmetric, or a row does not
    exist; or if no value is fixed in a component of the free rows on which constants are in the
    kernel (the message names a row of it)
  \throws Indefinite_matrix if rounding makes the matrix indefinite
  \complexity that of a sparse factorization, or linear in the number of entries
  */
  Fixed_values_solver(const Eigen::SparseMatrix<double>& a, std::span<const std::uint32_t> rows,
                      Linear_solver solver = Linear_solver::automatic);

  /*!
  \brief solves for some right sides.
  \param b right sides, a column each
  \param values a value per fixed row as they were given, and column of `b`; equal ones for repeated
  rows
  \return the solutions, a column each, with exactly the fixed values
  \throws std::invalid_argument if sizes do not fit, a number is not finite, or a row has two values
  \throws No_convergence if an iteration does not reach its tolerance
  \complexity linear in the entries of the factor, or of the matrix for each step, for each column
  */
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b, const Eigen::MatrixXd& values) const;

private:
  Eigen::MatrixXd fixed_part(const Eigen::MatrixXd& b, const Eigen::MatrixXd& values) const;

  std::vector<std::uint32_t> rows_;    // fixed ones, in the given order
  Eigen::SparseMatrix<double> matrix_; // with the sign that makes it positive definite
  double sign_ = 1;
  std::optional<internal::Chosen_factorization<double>>
      factorization_; // none if all rows are fixed
};

namespace internal {

// The same once. Where the rule has chosen an iteration that does not converge, it factors.
Eigen::MatrixXd solve_with_fixed_values(const Eigen::SparseMatrix<double>& a,
                                        const Eigen::MatrixXd& b,
                                        std::span<const std::uint32_t> rows,
                                        const Eigen::MatrixXd& values, Linear_solver solver);

} // namespace internal

/*!
\brief solves a symmetric linear problem `a x = b` with given values in some rows (Dirichlet
conditions), once; see `Fixed_values_solver`.

\param a the matrix, both triangles of it \pre definite on the free rows: positive, or negative
\param b the right side, a problem per column
\param rows the fixed rows, in any order; a row may be repeated with the same value
\param values a value per fixed row, and column of `b`
\param solver how to solve for the free rows
\return the solutions, a column each, with exactly the fixed values
\throws std::invalid_argument if sizes do not fit, a number is not finite, the matrix is not
  symmetric, a row does not exist or has two values; or if no value is fixed in a component of the
  free rows on which constants are in the kernel
\throws Indefinite_matrix if rounding makes the matrix indefinite
\throws No_convergence if an iteration does not reach its tolerance
\complexity that of a sparse factorization, once for all columns; or linear in the number of entries
  for each step and column
*/
template <class B, class Values>
  requires std::same_as<typename B::Scalar, double> && std::same_as<typename Values::Scalar, double>
typename B::PlainObject solve_with_fixed_values(const Eigen::SparseMatrix<double>& a,
                                                const Eigen::MatrixBase<B>& b,
                                                std::span<const std::uint32_t> rows,
                                                const Eigen::MatrixBase<Values>& values,
                                                Linear_solver solver = Linear_solver::automatic) {
  return internal::solve_with_fixed_values(a, b, rows, values, solver);
}

/*!
\brief finds a row of each component of a symmetric matrix in which all rows sum to zero up to
rounding, so that constants there are in its kernel.

For a cotangent Laplacian: a vertex of each component of the surface, and every isolated vertex.
\return the least row of each, in ascending order
\complexity linear in the number of entries
*/
std::vector<std::uint32_t> rows_with_constant_kernel(const Eigen::SparseMatrix<double>& a);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_FIXED_VALUES_SOLVER_H
