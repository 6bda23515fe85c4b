// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/distance/Pinned_laplacian.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// a factorization with its ordering takes the time of at least so many solutions: 20 at 26,000
// vertices, 50 at 416,000
static constexpr std::size_t few_pins = 20;

Eigen::VectorXd Pinned_laplacian::solve(const Eigen::VectorXd& b, const Pins& pins) {
  std::vector<char> is_reached(component_.size(), 0); // of the least rows
  for (const auto& [row, value] : pins) is_reached[component_[row_number(row)]] = 1;
  Eigen::VectorXd x =
      pins.size() <= few_pins ? solve_for_few(b, pins) : solve_for_many(b, pins, is_reached);
  for (Eigen::Index r = 0; r < x.size(); ++r)
    if (is_reached[component_[row_number(r)]] == 0) x[r] = std::numeric_limits<double>::infinity();
  for (const auto& [row, value] : pins) x[row] = value;
  return x;
}

// Raises one diagonal entry per component: for right sides that sum to zero, this fixes one value
// at zero. Isolated vertices have a row of zeros.
Eigen::VectorXd Pinned_laplacian::pinned_diagonal() const {
  Eigen::VectorXd added = Eigen::VectorXd::Zero(laplacian_->cols());
  for (int r = 0; r < laplacian_->cols(); ++r)
    if (component_[row_number(r)] == static_cast<std::uint32_t>(r)) {
      const double diagonal = laplacian_->coeff(r, r);
      added[r] = diagonal > 0 ? diagonal : 1;
    }
  return added;
}

Laplacian_factorization Pinned_laplacian::factor_with_multiple(double multiple,
                                                               const Eigen::VectorXd& diagonal) {
  try {
    auto both =
        Laplacian_factorization::of_both(*laplacian_, pinned_diagonal(), multiple, diagonal);
    factored_.emplace(std::move(both.first));
    return std::move(both.second);
  } catch (const Indefinite_matrix&) {
    return {multiple * *laplacian_, diagonal}; // L may not be needed
  }
}

// Adds to the solution in column 0 the part of the pins of a component; the solutions for unit
// strengths start at `column`.
static Eigen::VectorXd correction_by_strengths(const Eigen::MatrixXd& solved, Eigen::Index column,
                                               const std::vector<int>& rows,
                                               const Pinned_laplacian::Pins& pins) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + 1, n + 1);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const int row = rows[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < n; ++j) a(i, j) = solved(row, column + j);
    a(i, n) = a(n, i) = 1;
    b[i] = pins.at(row) - solved(row, 0);
  }
  const Eigen::VectorXd l = a.fullPivLu().solve(b);
  Eigen::VectorXd result = solved.middleCols(column, n) * l.head(n);
  result.array() += l[n];
  return result;
}

Eigen::VectorXd Pinned_laplacian::solve_for_few(const Eigen::VectorXd& b, const Pins& pins) {
  std::map<std::uint32_t, std::vector<int>> rows; // the pins of each component
  for (const auto& [row, value] : pins) rows[component_[row_number(row)]].push_back(row);
  std::vector<int> sources; // rows with an unknown strength: not of single pins
  for (const auto& [root, of_component] : rows)
    if (of_component.size() > 1)
      sources.insert(sources.end(), of_component.begin(), of_component.end());
  Eigen::MatrixXd right =
      Eigen::MatrixXd::Zero(b.size(), static_cast<Eigen::Index>(sources.size()) + 1);
  right.col(0) = b;
  for (std::size_t i = 0; i < sources.size(); ++i)
    right(sources[i], static_cast<Eigen::Index>(i) + 1) = 1;
  if (!factored_) factored_.emplace(*laplacian_, pinned_diagonal());
  const Eigen::MatrixXd solved = factored_->solve(right);
  Eigen::VectorXd x = solved.col(0);
  Eigen::Index column = 1;
  for (const auto& [root, of_component] : rows) {
    Eigen::VectorXd correction;
    if (of_component.size() == 1) {
      correction.setConstant(x.size(), pins.at(of_component[0]) - x[of_component[0]]);
    } else {
      correction = correction_by_strengths(solved, column, of_component, pins);
      column += static_cast<Eigen::Index>(of_component.size());
    }
    for (Eigen::Index r = 0; r < x.size(); ++r)
      if (component_[row_number(r)] == root) x[r] += correction[r];
  }
  return x;
}

// Where there is no pin, any value will do.
Eigen::VectorXd Pinned_laplacian::solve_for_many(const Eigen::VectorXd& b, const Pins& pins,
                                                 const std::vector<char>& is_reached) {
  std::vector<std::uint32_t> rows;
  for (const auto& [row, value] : pins) rows.push_back(static_cast<std::uint32_t>(row));
  for (std::uint32_t r = 0; r < component_.size(); ++r)
    if (component_[r] == r && is_reached[r] == 0) rows.push_back(r);
  if (!fixed_ || rows != fixed_rows_) {
    fixed_.emplace(*laplacian_, rows);
    fixed_rows_ = rows;
  }
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.size()));
  Eigen::Index i = 0;
  for (const auto& [row, value] : pins) values[i++] = value;
  return fixed_->solve(b, values);
}

} // namespace CGAL::Intrinsic_triangulations::internal
