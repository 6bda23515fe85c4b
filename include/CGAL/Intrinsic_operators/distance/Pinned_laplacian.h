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
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
Solves L x = b with given values in some rows, the *pins*. The Laplacian stays the same, the pins
change. On a component without pins x is infinite.

With one pin in a component, any solution and a constant give x. A few pins need as many Lagrange
multipliers: L x = b + sum over pins of l_s e_s, where the l sum to zero; all pins use the same
factorization of L. Many pins need a `Fixed_values_solver`, which is kept for the next right side
with pins in the same rows.
*/
class Pinned_laplacian {
public:
  using Pins = std::map<int, double>; // by rows

  // \param component of each row, as the least of its rows
  Pinned_laplacian(Eigen::SparseMatrix<double> laplacian, std::vector<std::uint32_t> component)
      : laplacian_(std::make_shared<const Eigen::SparseMatrix<double>>(std::move(laplacian))),
        component_(std::move(component)) {}

  const std::shared_ptr<const Eigen::SparseMatrix<double>>& laplacian() const { return laplacian_; }

  // Factors L and, with a diagonal, a multiple of L; only the multiple if rounding leaves L
  // indefinite.
  // \return the factorization of the multiple \throws Indefinite_matrix if it is not definite
  Laplacian_factorization factor_with_multiple(double multiple, const Eigen::VectorXd& diagonal);

  Eigen::VectorXd solve(const Eigen::VectorXd& b, const Pins& pins);

private:
  Eigen::VectorXd pinned_diagonal() const;
  Eigen::VectorXd solve_for_few(const Eigen::VectorXd& b, const Pins& pins);
  Eigen::VectorXd solve_for_many(const Eigen::VectorXd& b, const Pins& pins,
                                 const std::vector<char>& is_reached);

  std::shared_ptr<const Eigen::SparseMatrix<double>> laplacian_;
  std::vector<std::uint32_t> component_;
  std::optional<Laplacian_factorization> factored_;
  std::vector<std::uint32_t> fixed_rows_;
  std::optional<Fixed_values_solver> fixed_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_PINNED_LAPLACIAN_H
