// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/distance/Pinned_laplacian.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Symbolic_factorization.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// a factorization with its ordering takes the time of at least so many solutions: 20 at 26,000
// vertices, 50 at 416,000
static bool are_few(const Pinned_laplacian::Pins& pins) { return pins.size() <= 20; }

struct Pinned_laplacian::Late_factorization {
  std::once_flag once;
  Shared_analysis analysis;
  std::optional<Laplacian_factorization> made;
};

Pinned_laplacian::Pinned_laplacian(Eigen::SparseMatrix<double> laplacian,
                                   std::vector<std::uint32_t> component)
    : laplacian_(std::make_shared<const Eigen::SparseMatrix<double>>(std::move(laplacian))),
      component_(std::move(component)), late_(std::make_shared<Late_factorization>()) {}

Eigen::MatrixXd Pinned_laplacian::solve(const Eigen::MatrixXd& b, std::span<const Pins> pins,
                                        Kept& kept) const {
  Eigen::MatrixXd x(b.rows(), b.cols());
  solve_for_few(b, pins, x);
  for (Eigen::Index c = 0; c < x.cols(); ++c) {
    const Pins& own = pins[row_number(c)];
    if (!are_few(own)) x.col(c) = solve_for_many(b.col(c), own, kept);
    const std::vector<char> is_reached = reached(own);
    for (Eigen::Index r = 0; r < x.rows(); ++r)
      if (is_reached[component_[row_number(r)]] == 0)
        x(r, c) = std::numeric_limits<double>::infinity();
    for (const auto& [row, value] : own) x(row, c) = value;
  }
  return x;
}

// Marks the components with pins, at their least rows.
std::vector<char> Pinned_laplacian::reached(const Pins& pins) const {
  std::vector<char> is_reached(component_.size(), 0);
  for (const auto& [row, value] : pins) is_reached[component_[row_number(row)]] = 1;
  return is_reached;
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

const Symbolic_factorization& Pinned_laplacian::analysis() {
  analyze(*laplacian_, late_->analysis);
  return *late_->analysis;
}

const Laplacian_factorization& Pinned_laplacian::factored() const {
  std::call_once(late_->once, [this] {
    if (!late_->made) late_->made.emplace(*laplacian_, pinned_diagonal(), late_->analysis);
  });
  return *late_->made;
}

Laplacian_factorization Pinned_laplacian::factor_with_multiple(double multiple,
                                                               const Eigen::VectorXd& diagonal) {
  try {
    auto both =
        Laplacian_factorization::of_both(*laplacian_, pinned_diagonal(), multiple, diagonal);
    late_->made.emplace(std::move(both.first));
    return std::move(both.second);
  } catch (const Indefinite_matrix&) {
    return {multiple * *laplacian_, diagonal}; // L may not be needed
  }
}

// What the pins of a component add to the solution in column `base`; the solutions for unit
// strengths start at `column`.
static Eigen::VectorXd correction_by_strengths(const Eigen::MatrixXd& solved, Eigen::Index base,
                                               Eigen::Index column, const std::vector<int>& rows,
                                               const Pinned_laplacian::Pins& pins) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + 1, n + 1);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const int row = rows[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < n; ++j) a(i, j) = solved(row, column + j);
    a(i, n) = a(n, i) = 1;
    b[i] = pins.at(row) - solved(row, base);
  }
  const Eigen::VectorXd l = a.fullPivLu().solve(b);
  Eigen::VectorXd result = solved.middleCols(column, n) * l.head(n);
  result.array() += l[n];
  return result;
}

void Pinned_laplacian::solve_for_few(const Eigen::MatrixXd& b, std::span<const Pins> pins,
                                     Eigen::MatrixXd& x) const {
  std::vector<Few_pins> few;
  std::vector<int> sources; // rows with an unknown strength; -1 for the right side itself
  for (std::size_t c = 0; c < pins.size(); ++c) {
    if (!are_few(pins[c])) continue;
    few.push_back({static_cast<Eigen::Index>(c), {}, static_cast<Eigen::Index>(sources.size())});
    auto& rows = few.back().rows;
    for (const auto& [row, value] : pins[c]) rows[component_[row_number(row)]].push_back(row);
    sources.push_back(-1);
    for (const auto& [root, of_component] : rows) // single pins have no unknown strength
      if (of_component.size() > 1)
        sources.insert(sources.end(), of_component.begin(), of_component.end());
  }
  if (few.empty()) return;
  Eigen::MatrixXd right =
      Eigen::MatrixXd::Zero(b.rows(), static_cast<Eigen::Index>(sources.size()));
  for (const Few_pins& f : few) right.col(f.first_solved) = b.col(f.column);
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (sources[i] >= 0) right(sources[i], static_cast<Eigen::Index>(i)) = 1;
  const Eigen::MatrixXd solved = factored().solve(right);
  for (const Few_pins& f : few) {
    x.col(f.column) = solved.col(f.first_solved);
    correct(f, pins[row_number(f.column)], solved, x);
  }
}

// Adds what the pins of a column change on their components.
void Pinned_laplacian::correct(const Few_pins& few, const Pins& pins, const Eigen::MatrixXd& solved,
                               Eigen::MatrixXd& x) const {
  Eigen::Index column = few.first_solved + 1;
  for (const auto& [root, rows] : few.rows) {
    Eigen::VectorXd correction;
    if (rows.size() == 1) {
      correction.setConstant(x.rows(), pins.at(rows[0]) - x(rows[0], few.column));
    } else {
      correction = correction_by_strengths(solved, few.first_solved, column, rows, pins);
      column += static_cast<Eigen::Index>(rows.size());
    }
    for (Eigen::Index r = 0; r < x.rows(); ++r)
      if (component_[row_number(r)] == root) x(r, few.column) += correction[r];
  }
}

// Where there is no pin, any value will do.
Eigen::VectorXd Pinned_laplacian::solve_for_many(const Eigen::VectorXd& b, const Pins& pins,
                                                 Kept& kept) const {
  const std::vector<char> is_reached = reached(pins);
  std::vector<std::uint32_t> rows;
  for (const auto& [row, value] : pins) rows.push_back(static_cast<std::uint32_t>(row));
  for (std::uint32_t r = 0; r < component_.size(); ++r)
    if (component_[r] == r && is_reached[r] == 0) rows.push_back(r);
  if (!kept.solver || rows != kept.rows) {
    kept.solver.emplace(*laplacian_, rows);
    kept.rows = rows;
  }
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.size()));
  Eigen::Index i = 0;
  for (const auto& [row, value] : pins) values[i++] = value;
  return kept.solver->solve(b, values);
}

} // namespace CGAL::Intrinsic_triangulations::internal
