// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_PINNED_LAPLACIAN_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_PINNED_LAPLACIAN_H

#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
Solves L x = b with given values in some rows, the *pins*. The Laplacian stays the same, the pins
change. On a component without pins x is infinite.

With one pin in a component, any solution and a constant give x. A few pins need as many Lagrange
multipliers: L x = b + sum over pins of l_s e_s, where the l sum to zero; all pins use the same
factorization of L. Many pins need a `Fixed_values_solver`, which the caller keeps for the next
right side with pins in the same rows.

Several threads may solve at once, each with what it keeps. Copies share the factorization.
*/
class Pinned_laplacian {
public:
  using Pins = std::map<int, double>; // by rows

  // the factorization for many pins that was used last
  struct Kept {
    std::vector<std::uint32_t> rows;
    std::optional<Fixed_values_solver> solver;
  };

  // \param component of each row, as the least of its rows
  Pinned_laplacian(Eigen::SparseMatrix<double> laplacian, std::vector<std::uint32_t> component);

  const std::shared_ptr<const Eigen::SparseMatrix<double>>& laplacian() const { return laplacian_; }

  // The analysis of the Laplacian for its factorization. Not to be called from two threads at once.
  const Symbolic_factorization& analysis();

  // Factors L and, with a diagonal, a multiple of L; only the multiple if rounding leaves L
  // indefinite.
  // \return the factorization of the multiple \throws Indefinite_matrix if it is not definite
  Laplacian_factorization factor_with_multiple(double multiple, const Eigen::VectorXd& diagonal);

  // \param b right sides, a column each \param pins of each column
  // \return the solutions, bit by bit those of single calls
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b, std::span<const Pins> pins, Kept& kept) const;

private:
  // A factorization that the first thread makes that needs it.
  struct Late_factorization;

  // The pins of one column, by their components.
  struct Few_pins {
    Eigen::Index column; // of right sides and solutions
    std::map<std::uint32_t, std::vector<int>> rows;
    Eigen::Index first_solved; // of the systems solved; those for unit strengths follow
  };

  const Laplacian_factorization& factored() const;
  Eigen::VectorXd pinned_diagonal() const;
  std::vector<char> reached(const Pins& pins) const;
  void solve_for_few(const Eigen::MatrixXd& b, std::span<const Pins> pins,
                     Eigen::MatrixXd& x) const;
  void correct(const Few_pins& few, const Pins& pins, const Eigen::MatrixXd& solved,
               Eigen::MatrixXd& x) const;
  Eigen::VectorXd solve_for_many(const Eigen::VectorXd& b, const Pins& pins, Kept& kept) const;

  std::shared_ptr<const Eigen::SparseMatrix<double>> laplacian_;
  std::vector<std::uint32_t> component_;
  std::shared_ptr<Late_factorization> late_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_PINNED_LAPLACIAN_H
