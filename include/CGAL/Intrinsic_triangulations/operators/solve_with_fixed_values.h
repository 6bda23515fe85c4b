// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVE_WITH_FIXED_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVE_WITH_FIXED_VALUES_H

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The rows of a linear problem: which are fixed, at which values, and which are free.
class Fixed_rows {
public:
  using Matrix = Eigen::SparseMatrix<double>;

  Fixed_rows(Eigen::Index size, const Eigen::MatrixXd& b, std::span<const std::uint32_t> rows,
             const Eigen::MatrixXd& values)
      : fixed_(Eigen::MatrixXd::Zero(size, b.cols())),
        is_fixed_(static_cast<std::size_t>(size), 0) {
    if (values.rows() != static_cast<Eigen::Index>(rows.size()) || values.cols() != b.cols())
      throw std::invalid_argument("there must be a value per fixed row and column of b, not " +
                                  std::to_string(values.rows()) + " x " +
                                  std::to_string(values.cols()));
    for (std::size_t i = 0; i < rows.size(); ++i)
      fix(rows[i], values.row(static_cast<Eigen::Index>(i)));
    for (Eigen::Index r = 0; r < size; ++r)
      if (is_fixed_[static_cast<std::size_t>(r)] == 0) free_.push_back(static_cast<int>(r));
  }

  // the fixed values, zero in free rows
  const Eigen::MatrixXd& fixed() const { return fixed_; }
  // the free rows
  const std::vector<int>& free() const { return free_; }
  // the matrix that makes rows of free ones
  Matrix selection() const {
    Matrix s(fixed_.rows(), static_cast<Eigen::Index>(free_.size()));
    s.reserve(s.cols());
    for (int c = 0; c < s.cols(); ++c) {
      s.startVec(c);
      s.insertBack(free_[static_cast<std::size_t>(c)], c) = 1;
    }
    s.finalize();
    return s;
  }

private:
  void fix(std::uint32_t r, const Eigen::RowVectorXd& value) {
    if (r >= is_fixed_.size())
      throw std::invalid_argument("row " + std::to_string(r) + " is fixed, but the matrix has " +
                                  std::to_string(is_fixed_.size()) + " rows");
    if (is_fixed_[r] != 0 && fixed_.row(r) != value)
      throw std::invalid_argument("row " + std::to_string(r) + " is fixed at two different values");
    is_fixed_[r] = 1;
    fixed_.row(r) = value;
  }

  Eigen::MatrixXd fixed_;
  std::vector<char> is_fixed_;
  std::vector<int> free_;
};

inline bool has_finite_entries(const Eigen::SparseMatrix<double>& a) {
  for (int c = 0; c < a.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, c); i; ++i)
      if (!std::isfinite(i.value())) return false;
  return true;
}

inline void check_linear_problem(const Eigen::SparseMatrix<double>& a, const Eigen::MatrixXd& b,
                                 const Eigen::MatrixXd& values) {
  if (a.rows() != a.cols() || b.rows() != a.rows())
    throw std::invalid_argument("the matrix must be square, and b have a row per row of it; they "
                                "have " +
                                std::to_string(a.rows()) + " x " + std::to_string(a.cols()) +
                                " and " + std::to_string(b.rows()));
  if (!has_finite_entries(a) || !b.allFinite() || !values.allFinite())
    throw std::invalid_argument("the matrix, b and the fixed values must be finite");
  const Eigen::SparseMatrix<double> transposed = a.transpose();
  // what rounding makes of a product of matrices is no asymmetry
  if ((a - transposed).norm() > 0x1p-30 * a.norm())
    throw std::invalid_argument("the matrix must be symmetric; give both triangles of it");
}

// A row of a component all rows of which sum to zero, so that constants there are in the kernel; -1: there is none.
inline int row_with_constant_kernel(const Eigen::SparseMatrix<double>& a) {
  const auto size = static_cast<std::size_t>(a.cols());
  std::vector<std::size_t> parent(size);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&parent](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  std::vector<char> is_zero_sum(size, 0);
  for (int c = 0; c < a.outerSize(); ++c) {
    double sum = 0, absolute = 0;
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, c); i; ++i) {
      sum += i.value();
      absolute += std::abs(i.value());
      if (i.value() != 0)
        parent[root(static_cast<std::size_t>(i.row()))] = root(static_cast<std::size_t>(c));
    }
    is_zero_sum[static_cast<std::size_t>(c)] = std::abs(sum) <= 0x1p-46 * absolute ? 1 : 0;
  }
  std::vector<char> has_kernel(size, 1);
  for (std::size_t c = 0; c < size; ++c)
    if (is_zero_sum[c] == 0) has_kernel[root(c)] = 0;
  for (std::size_t c = 0; c < size; ++c)
    if (has_kernel[root(c)] != 0) return static_cast<int>(c);
  return -1;
}

// Solves the free part. `names` are its rows in the whole problem.
inline Eigen::MatrixXd solve_free_rows(const Eigen::SparseMatrix<double>& a,
                                       const Eigen::MatrixXd& b, const std::vector<int>& names) {
  const auto name = [&names](int row) {
    return std::to_string(names[static_cast<std::size_t>(row)]);
  };
  if (const int r = row_with_constant_kernel(a); r >= 0)
    throw std::invalid_argument("no value is fixed in the component of row " + name(r) +
                                ", where constants may be added to any solution; fix one there");
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(a);
  const Eigen::VectorXd pivots = solver.vectorD(), diagonal = a.diagonal();
  for (int r = 0; r < a.cols(); ++r) {
    const double pivot = std::abs(pivots[solver.permutationP().indices()[r]]);
    // less than what rounding has left in it
    if (!(pivot > 64 * std::numeric_limits<double>::epsilon() * std::abs(diagonal[r])))
      throw std::runtime_error("the matrix of the free rows is singular up to rounding, at row " +
                               name(r));
  }
  return solver.solve(b);
}

} // namespace internal

/*!
\brief solves a symmetric linear problem `a x = b` with given values in some rows (Dirichlet conditions), by
elimination of these: what is left is

    A_ff x_f = b_f - A_fc x_c

with f the free rows and c the fixed ones, in which the equations do not hold.

With `a` the cotangent Laplacian and `b` zero, x is the harmonic function with these values; with `b` the mass matrix
times f, the solution of a Poisson problem. Rows are those of vertices, `t.input_vertex(v)`, inserted ones included.

\param a the matrix, both triangles of it \pre definite on the free rows: positive, or negative
\param b the right side, a problem per column
\param rows the fixed rows, in any order; a row may be repeated with the same value
\param values a value per fixed row, and column of `b`
\return the solutions, a column each; fixed values are there bit by bit
\throws std::invalid_argument if sizes do not fit, a number is not finite, the matrix is not symmetric, a row does not
  exist or has two values; or if no value is fixed in a component of the free rows on which constants are in the kernel
  (the message names a row of it), so that there are infinitely many solutions or none
\throws std::runtime_error if rounding has left no definite matrix (the message names a row)
\complexity that of a sparse factorization, once for all columns
*/
template <class B, class Values>
  requires std::same_as<typename B::Scalar, double> && std::same_as<typename Values::Scalar, double>
typename B::PlainObject solve_with_fixed_values(const Eigen::SparseMatrix<double>& a,
                                                const Eigen::MatrixBase<B>& b,
                                                std::span<const std::uint32_t> rows,
                                                const Eigen::MatrixBase<Values>& values) {
  const Eigen::MatrixXd right = b, given = values;
  internal::check_linear_problem(a, right, given);
  const internal::Fixed_rows f(a.rows(), right, rows, given);
  if (f.free().empty()) return f.fixed();
  const Eigen::SparseMatrix<double> selection = f.selection(), transposed = selection.transpose();
  const Eigen::SparseMatrix<double> free_part = transposed * a * selection;
  return f.fixed() + selection * internal::solve_free_rows(
                                     free_part, transposed * (right - a * f.fixed()), f.free());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVE_WITH_FIXED_VALUES_H
