// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Multigrid_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The mean of a matrix and its transpose, if it is symmetric up to rounding, like a product of
// matrices.
static Eigen::SparseMatrix<double> symmetrized(const Eigen::SparseMatrix<double>& a) {
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

// The diagonal that the free part adds to a Laplacian: the sums of its rows, minus the entries of
// fixed ones. If all sums of a component are zero up to rounding, they become zero.
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

// Refuses components without any excess: solutions there are not unique, up to constants.
static void expect_excess(const Eigen::VectorXd& excess,
                          const std::vector<std::uint32_t>& component) {
  const std::vector<char> has_none =
      components_where_all(component, [&](Eigen::Index r) { return excess[r] == 0; });
  for (const std::uint32_t row : least_rows(component, has_none))
    throw std::invalid_argument("no value is fixed in the component of row " + std::to_string(row) +
                                ", where constants may be added to any solution; fix one there");
}

// With negative weights, as at the border, both ways subtract; if one fails, the other may work.
static Chosen_factorization<double> factored_with_subtraction(const Eigen::SparseMatrix<double>& a,
                                                              const Eigen::VectorXd& excess) {
  try {
    return Chosen_factorization<double>(Cholesky_factorization<double>(a));
  } catch (const Indefinite_matrix&) {
    return Chosen_factorization<double>(Laplacian_factorization(a, excess));
  }
}

} // namespace internal

std::vector<std::uint32_t> rows_with_constant_kernel(const Eigen::SparseMatrix<double>& a) {
  const std::vector<std::uint32_t> component = components_of_matrix(a);
  return internal::least_rows(component,
                              internal::laplacian_components(internal::Row_sums(a), component));
}

Fixed_values_solver::Fixed_values_solver(const Eigen::SparseMatrix<double>& a,
                                         std::span<const std::uint32_t> rows, Linear_solver solver)
    : rows_(rows.begin(), rows.end()), matrix_(internal::symmetrized(a)) {
  const std::vector<char> is_fixed = internal::marked_rows(a.rows(), rows);
  const auto first = std::find(is_fixed.begin(), is_fixed.end(), 0) - is_fixed.begin();
  if (first == a.rows()) return;
  if (matrix_.coeff(first, first) < 0) sign_ = -1;
  matrix_ *= sign_;
  Eigen::SparseMatrix<double> free_part = internal::with_fixed_rows(matrix_, is_fixed);
  const std::vector<std::uint32_t> component = components_of_matrix(free_part);
  internal::Free_excess found(matrix_, is_fixed, component);
  internal::expect_excess(found.excess, component);
  const bool is_free_of_subtraction =
      found.excess.minCoeff() >= 0 &&
      (found.is_laplacian || internal::has_no_positive_entry_off_diagonal(free_part));
  if (is_free_of_subtraction)
    factorization_ =
        internal::chosen_factorization(std::move(free_part), std::move(found.excess), solver);
  else
    factorization_ = internal::chosen_factorization<double>(
        free_part.cols(), solver,
        [&] { return Multigrid_factorization<double>(free_part, found.excess); },
        [free_part, excess = found.excess] {
          return internal::factored_with_subtraction(free_part, excess);
        });
}

Eigen::MatrixXd Fixed_values_solver::fixed_part(const Eigen::MatrixXd& b,
                                                const Eigen::MatrixXd& values) const {
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

Eigen::MatrixXd Fixed_values_solver::solve(const Eigen::MatrixXd& b,
                                           const Eigen::MatrixXd& values) const {
  Eigen::MatrixXd x = fixed_part(b, values);
  Eigen::MatrixXd right = sign_ * b - matrix_ * x;
  for (const std::uint32_t r : rows_) right.row(r).setZero(); // leaves exactly zero there
  if (factorization_) x += factorization_->solve(right);
  return x;
}

Eigen::MatrixXd internal::solve_with_fixed_values(const Eigen::SparseMatrix<double>& a,
                                                  const Eigen::MatrixXd& b,
                                                  std::span<const std::uint32_t> rows,
                                                  const Eigen::MatrixXd& values,
                                                  Linear_solver solver) {
  if (chosen_solver(solver, a.rows(), b.cols()) == Linear_solver::direct)
    return Fixed_values_solver(a, rows, Linear_solver::direct).solve(b, values);
  try {
    return Fixed_values_solver(a, rows, Linear_solver::iterative).solve(b, values);
  } catch (const std::runtime_error&) { // no convergence, or indefinite by negative weights
    if (solver == Linear_solver::iterative) throw;
  }
  return Fixed_values_solver(a, rows, Linear_solver::direct).solve(b, values);
}

} // namespace CGAL::Intrinsic_triangulations
