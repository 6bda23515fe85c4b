// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_FIXED_VALUES_SOLVER_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_FIXED_VALUES_SOLVER_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Row_sums.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/components_of_matrix.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

inline bool has_finite_entries(const Eigen::SparseMatrix<double>& a) {
  for (int c = 0; c < a.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, c); i; ++i)
      if (!std::isfinite(i.value())) return false;
  return true;
}

// The mean of a matrix and its transpose, if it is symmetric up to rounding, as a product of matrices is.
inline Eigen::SparseMatrix<double> symmetrized(const Eigen::SparseMatrix<double>& a) {
  if (a.rows() != a.cols())
    throw std::invalid_argument("the matrix must be square, not " + std::to_string(a.rows()) +
                                " x " + std::to_string(a.cols()));
  if (!has_finite_entries(a)) throw std::invalid_argument("the matrix must be finite");
  const Eigen::SparseMatrix<double> transposed = a.transpose();
  if ((a - transposed).norm() > 0x1p-30 * a.norm())
    throw std::invalid_argument("the matrix must be symmetric; give both triangles of it");
  return 0.5 * (a + transposed);
}

// per row: the place among the free ones, or -1
inline std::vector<int> places_of_free_rows(Eigen::Index size,
                                            std::span<const std::uint32_t> fixed) {
  std::vector<int> place(static_cast<std::size_t>(size), 0);
  for (const std::uint32_t r : fixed) {
    if (r >= place.size())
      throw std::invalid_argument("row " + std::to_string(r) + " is fixed, but the matrix has " +
                                  std::to_string(size) + " rows");
    place[r] = -1;
  }
  int count = 0;
  for (int& p : place)
    if (p == 0) p = count++;
  return place;
}

// the matrix that makes rows of free ones
inline Eigen::SparseMatrix<double> free_selection(const std::vector<int>& place, int count) {
  Eigen::SparseMatrix<double> s(static_cast<int>(place.size()), count);
  s.reserve(count);
  for (std::size_t r = 0; r < place.size(); ++r) {
    if (place[r] < 0) continue;
    s.startVec(place[r]);
    s.insertBack(static_cast<int>(r), place[r]) = 1;
  }
  s.finalize();
  return s;
}

// The diagonal beside which the free part is a Laplacian: what the rows sum to, with minus the entries of fixed ones. Where all sums of a
// component are zero but for rounding, they are.
struct Free_excess {
  Free_excess(const Eigen::SparseMatrix<double>& coupling, const std::vector<int>& free,
              const std::vector<std::uint32_t>& component)
      : excess(Eigen::VectorXd::Zero(coupling.rows())) {
    std::vector<char> is_fixed(static_cast<std::size_t>(coupling.cols()), 1);
    for (const int r : free) is_fixed[static_cast<std::size_t>(r)] = 0;
    for (int c = 0; c < coupling.outerSize(); ++c)
      if (is_fixed[static_cast<std::size_t>(c)] != 0)
        for (Eigen::SparseMatrix<double>::InnerIterator i(coupling, c); i; ++i)
          excess[i.row()] -= i.value();
    const Row_sums sums(coupling);
    const std::vector<char> is_laplacian_there = laplacian_components(sums, component);
    for (std::size_t r = 0; r < component.size(); ++r) {
      if (is_laplacian_there[component[r]] != 0) continue;
      is_laplacian = false;
      excess[static_cast<Eigen::Index>(r)] += sums.sum[static_cast<Eigen::Index>(r)];
    }
  }

  Eigen::VectorXd excess;
  bool is_laplacian = true; // whether that is so in all components
};

// Marks the components, at their least rows, without any excess: to solutions there, constants may be added.
inline std::vector<char> components_without_excess(const Eigen::VectorXd& excess,
                                                   const std::vector<std::uint32_t>& component) {
  std::vector<char> result(component.size(), 1);
  for (std::size_t r = 0; r < component.size(); ++r)
    if (excess[static_cast<Eigen::Index>(r)] != 0) result[component[r]] = 0;
  return result;
}

// The least rows of the components that are marked.
inline std::vector<std::uint32_t> least_rows(const std::vector<std::uint32_t>& component,
                                             const std::vector<char>& is_marked) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t r = 0; r < component.size(); ++r)
    if (component[r] == r && is_marked[r] != 0) rows.push_back(r);
  return rows;
}

[[noreturn]] inline void throw_no_value_in_component(int row) {
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
    : rows_(rows.begin(), rows.end()) {
  const Eigen::SparseMatrix<double> symmetric = internal::symmetrized(a);
  const std::vector<int> place = internal::places_of_free_rows(a.rows(), rows);
  for (std::size_t r = 0; r < place.size(); ++r)
    if (place[r] >= 0) free_.push_back(static_cast<int>(r));
  const Eigen::SparseMatrix<double> selection =
      internal::free_selection(place, static_cast<int>(free_.size()));
  coupling_ = selection.transpose() * symmetric;
  if (free_.empty()) return;
  Eigen::SparseMatrix<double> free_part = coupling_ * selection;
  if (free_part.coeff(0, 0) < 0) sign_ = -1;
  free_part *= sign_;
  const std::vector<std::uint32_t> component = components_of_matrix(free_part);
  const internal::Free_excess found(sign_ * coupling_, free_, component);
  const std::vector<std::uint32_t> undetermined =
      internal::least_rows(component, internal::components_without_excess(found.excess, component));
  if (!undetermined.empty()) internal::throw_no_value_in_component(free_[undetermined.front()]);
  try {
    if (found.excess.minCoeff() >= 0 &&
        (found.is_laplacian || internal::has_no_positive_entry_off_diagonal(free_part)))
      factorization_.emplace<Laplacian_factorization>(free_part, found.excess);
    else
      factor_with_subtraction(free_part, found.excess);
  } catch (const Indefinite_matrix& error) {
    throw Indefinite_matrix(free_[static_cast<std::size_t>(error.row())]);
  }
}

// With negative weights, as at the border, neither way is free of subtraction; where one fails, the other may do.
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
  if (b.rows() != coupling_.cols())
    throw std::invalid_argument("b must have a row per row of the matrix, " +
                                std::to_string(coupling_.cols()) + ", not " +
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
  Eigen::MatrixXd right = -(coupling_ * x);
  for (std::size_t i = 0; i < free_.size(); ++i)
    right.row(static_cast<Eigen::Index>(i)) += b.row(free_[i]);
  right *= sign_;
  const auto* laplacian = std::get_if<Laplacian_factorization>(&factorization_);
  const Eigen::MatrixXd solution =
      laplacian != nullptr ? laplacian->solve(right)
                           : std::get<Cholesky_factorization<double>>(factorization_).solve(right);
  for (std::size_t i = 0; i < free_.size(); ++i)
    x.row(free_[i]) = solution.row(static_cast<Eigen::Index>(i));
  return x;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_FIXED_VALUES_SOLVER_IMPL_H
