// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_SOLVE_WITH_FIXED_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_SOLVE_WITH_FIXED_VALUES_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/Fixed_values_solver.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <concepts>
#include <cstdint>
#include <span>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief solves a symmetric linear problem `a x = b` with given values in some rows (Dirichlet conditions), once.

See `Fixed_values_solver`, which keeps the factorization for more right sides and other values.

\param a the matrix, both triangles of it \pre definite on the free rows: positive, or negative
\param b the right side, a problem per column
\param rows the fixed rows, in any order; a row may be repeated with the same value
\param values a value per fixed row, and column of `b`
\return the solutions, a column each; fixed values are there bit by bit
\throws std::invalid_argument if sizes do not fit, a number is not finite, the matrix is not symmetric, a row does not
  exist or has two values; or if no value is fixed in a component of the free rows on which constants are in the kernel
\throws Indefinite_matrix if rounding has left no definite matrix
\complexity that of a sparse factorization, once for all columns
*/
template <class B, class Values>
  requires std::same_as<typename B::Scalar, double> && std::same_as<typename Values::Scalar, double>
typename B::PlainObject solve_with_fixed_values(const Eigen::SparseMatrix<double>& a,
                                                const Eigen::MatrixBase<B>& b,
                                                std::span<const std::uint32_t> rows,
                                                const Eigen::MatrixBase<Values>& values) {
  return Fixed_values_solver(a, rows).solve(b, values);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_SOLVE_WITH_FIXED_VALUES_H
