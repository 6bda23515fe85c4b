// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_FIXED_VALUES_SOLVER_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_FIXED_VALUES_SOLVER_H

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/compilation.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief solves symmetric linear problems `a x = b` with given values in some rows (Dirichlet conditions), which are eliminated:

    A_ff x_f = b_f - A_fc x_c

with f the free rows and c the fixed ones, in which the equations do not hold. What is left is factored once; right sides and
values may then be given many times. No condition on the border is the natural one (Neumann) of a cotangent Laplacian.

With `a` the cotangent Laplacian and `b` zero, x is the harmonic function with these values; with `b` the mass matrix
times f, the solution of a Poisson problem. With a row of `rows_with_constant_kernel()` fixed at zero it is solved up to a constant in each
component. The Laplacian of a graph without negative weights is factored without subtraction, see `Laplacian_factorization`: it stays definite, and solutions
accurate, whatever the weights are. Row sums that rounding may have made, in components where all are such, count as zero. Negative weights, as those of squares of
Laplacians, carry no promise beyond that of a Cholesky factorization. Rows are those of vertices, `t.input_vertex(v)`, inserted ones included.
*/
class Fixed_values_solver {
public:
  /*!
  \brief factors the free part of a matrix.
  \param a the matrix, both triangles of it \pre definite on the free rows: positive, or negative
  \param rows the fixed rows, in any order, repeated or not
  \throws std::invalid_argument if the matrix is not square, finite and symmetric, or a row does not exist; or if no value is fixed in a
    component of the free rows on which constants are in the kernel (the message names a row of it), so that there are infinitely many
    solutions or none
  \throws Indefinite_matrix if rounding has left no definite matrix
  \complexity that of a sparse factorization
  */
  Fixed_values_solver(const Eigen::SparseMatrix<double>& a, std::span<const std::uint32_t> rows);

  /*!
  \brief solves for some right sides.
  \param b right sides, a column each
  \param values a value per fixed row as they were given, and column of `b`; equal ones for rows that were repeated
  \return the solutions, a column each; fixed values are there bit by bit
  \throws std::invalid_argument if sizes do not fit, a number is not finite, or a row has two values
  \complexity linear in the entries of the factor, for each column
  */
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b, const Eigen::MatrixXd& values) const;

private:
  void factor_with_subtraction(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& excess);
  Eigen::MatrixXd fixed_part(const Eigen::MatrixXd& b, const Eigen::MatrixXd& values) const;

  std::vector<std::uint32_t> rows_;    // fixed ones, as they were given
  Eigen::SparseMatrix<double> matrix_; // with the sign, which makes it positive definite
  double sign_ = 1;
  // nothing, if all rows are fixed
  std::variant<std::monostate, Laplacian_factorization, Cholesky_factorization<double>>
      factorization_;
};

/*!
\brief solves a symmetric linear problem `a x = b` with given values in some rows (Dirichlet conditions), once; see `Fixed_values_solver`.

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

/*!
\brief finds a row of each component of a symmetric matrix in which all rows sum to zero up to rounding, so that constants there are in its kernel.

For a cotangent Laplacian that is a vertex of each component of the surface, and every isolated one.
\return the least row of each, in ascending order
\complexity linear in the number of entries
*/
std::vector<std::uint32_t> rows_with_constant_kernel(const Eigen::SparseMatrix<double>& a);

} // namespace CGAL::Intrinsic_triangulations

#if CGAL_INTRINSIC_TRIANGULATIONS_DEFINES(SOLVERS)
namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The mean of a matrix and its transpose, if it is symmetric up to rounding, as a product of
// matrices is.
inline Eigen::SparseMatrix<double> symmetrized(const Eigen::SparseMatrix<double>& a) {
  if (a.rows() != a.cols())
    throw std::invalid_argument("the matrix must be square, not " + std::to_string(a.rows()) +
                                " x " + std::to_string(a.cols()));
  const Eigen::SparseMatrix<double> transposed = a.transpose();
  if ((a - transposed).norm() > 0x1p-30 * a.norm())
    throw std::invalid_argument("the matrix must be symmetric; give both triangles of it");
  Eigen::SparseMatrix<double> mean = 0.5 * (a + transposed);
  if (!mean.coeffs().allFinite()) throw std::invalid_argument("the matrix must be finite");
  return mean;
}

inline std::vector<char> marked_rows(Eigen::Index size, std::span<const std::uint32_t> fixed) {
  std::vector<char> is_fixed(static_cast<std::size_t>(size), 0);
  for (const std::uint32_t r : fixed) {
    if (r >= is_fixed.size())
      throw std::invalid_argument("row " + std::to_string(r) + " is fixed, but the matrix has " +
                                  std::to_string(size) + " rows");
    is_fixed[r] = 1;
  }
  return is_fixed;
}

// The least rows of the components that are marked.
inline std::vector<std::uint32_t> least_rows(const std::vector<std::uint32_t>& component,
                                             const std::vector<char>& is_marked) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t r = 0; r < component.size(); ++r)
    if (component[r] == r && is_marked[r] != 0) rows.push_back(r);
  return rows;
}

// The diagonal beside which the free part is a Laplacian: what its rows sum to, with minus the
// entries of fixed ones. Where all sums of a component are zero but for rounding, they are.
struct Free_excess {
  Free_excess(const Eigen::SparseMatrix<double>& a, const std::vector<char>& is_fixed,
              const std::vector<std::uint32_t>& component)
      : excess(diagonal_with_fixed_rows(a, Eigen::VectorXd::Zero(a.cols()), is_fixed)) {
    const Row_sums sums(a);
    const std::vector<char> is_laplacian_there = laplacian_components(sums, component);
    for (std::size_t r = 0; r < component.size(); ++r) {
      if (is_fixed[r] != 0 || is_laplacian_there[component[r]] != 0) continue;
      is_laplacian = false;
      excess[static_cast<Eigen::Index>(r)] += sums.sum[static_cast<Eigen::Index>(r)];
    }
  }

  Eigen::VectorXd excess;
  bool is_laplacian = true; // whether that is so in all components
};

// Refuses components without any excess: to solutions there, constants may be added.
inline void expect_excess(const Eigen::VectorXd& excess,
                          const std::vector<std::uint32_t>& component) {
  std::vector<char> has_none(component.size(), 1);
  for (std::size_t r = 0; r < component.size(); ++r)
    if (excess[static_cast<Eigen::Index>(r)] != 0) has_none[component[r]] = 0;
  for (const std::uint32_t row : least_rows(component, has_none))
    throw std::invalid_argument("no value is fixed in the component of row " + std::to_string(row) +
                                ", where constants may be added to any solution; fix one there");
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::vector<std::uint32_t>
rows_with_constant_kernel(const Eigen::SparseMatrix<double>& a) {
  const std::vector<std::uint32_t> component = components_of_matrix(a);
  return internal::least_rows(component,
                              internal::laplacian_components(internal::Row_sums(a), component));
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Fixed_values_solver::Fixed_values_solver(const Eigen::SparseMatrix<double>& a,
                                         std::span<const std::uint32_t> rows)
    : rows_(rows.begin(), rows.end()), matrix_(internal::symmetrized(a)) {
  const std::vector<char> is_fixed = internal::marked_rows(a.rows(), rows);
  const auto first = std::find(is_fixed.begin(), is_fixed.end(), 0) - is_fixed.begin();
  if (first == a.rows()) return;
  if (matrix_.coeff(first, first) < 0) sign_ = -1;
  matrix_ *= sign_;
  const Eigen::SparseMatrix<double> free_part = internal::with_fixed_rows(matrix_, is_fixed);
  const std::vector<std::uint32_t> component = components_of_matrix(free_part);
  const internal::Free_excess found(matrix_, is_fixed, component);
  internal::expect_excess(found.excess, component);
  if (found.excess.minCoeff() >= 0 &&
      (found.is_laplacian || internal::has_no_positive_entry_off_diagonal(free_part)))
    factorization_.emplace<Laplacian_factorization>(free_part, found.excess);
  else
    factor_with_subtraction(free_part, found.excess);
}

// With negative weights, as at the border, neither way is free of subtraction; where one fails, the
// other may do.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Fixed_values_solver::factor_with_subtraction(const Eigen::SparseMatrix<double>& a,
                                             const Eigen::VectorXd& excess) {
  try {
    factorization_.emplace<Cholesky_factorization<double>>(a);
  } catch (const Indefinite_matrix&) {
    factorization_.emplace<Laplacian_factorization>(a, excess);
  }
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigen::MatrixXd
Fixed_values_solver::fixed_part(const Eigen::MatrixXd& b, const Eigen::MatrixXd& values) const {
  if (b.rows() != matrix_.cols())
    throw std::invalid_argument("b must have a row per row of the matrix, " +
                                std::to_string(matrix_.cols()) + ", not " +
                                std::to_string(b.rows()));
  if (values.rows() != static_cast<Eigen::Index>(rows_.size()) || values.cols() != b.cols())
    throw std::invalid_argument("there must be a value per fixed row and column of b, not " +
                                std::to_string(values.rows()) + " x " +
                                std::to_string(values.cols()));
  if (!b.allFinite() || !values.allFinite())
    throw std::invalid_argument("b and the fixed values must be finite");
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(b.rows(), b.cols());
  for (std::size_t i = 0; i < rows_.size(); ++i)
    x.row(rows_[i]) = values.row(static_cast<Eigen::Index>(i));
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (x.row(rows_[i]) != values.row(static_cast<Eigen::Index>(i)))
      throw std::invalid_argument("row " + std::to_string(rows_[i]) +
                                  " is fixed at two different values");
  return x;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigen::MatrixXd
Fixed_values_solver::solve(const Eigen::MatrixXd& b, const Eigen::MatrixXd& values) const {
  Eigen::MatrixXd x = fixed_part(b, values);
  if (std::holds_alternative<std::monostate>(factorization_)) return x;
  Eigen::MatrixXd right = sign_ * b - matrix_ * x;
  for (const std::uint32_t r : rows_) right.row(r).setZero(); // leaves exactly zero there
  const auto* laplacian = std::get_if<Laplacian_factorization>(&factorization_);
  return x + (laplacian != nullptr
                  ? laplacian->solve(right)
                  : std::get<Cholesky_factorization<double>>(factorization_).solve(right));
}

} // namespace CGAL::Intrinsic_triangulations
#endif

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_FIXED_VALUES_SOLVER_H
