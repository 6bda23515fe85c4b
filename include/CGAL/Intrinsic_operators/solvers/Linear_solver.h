// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_LINEAR_SOLVER_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_LINEAR_SOLVER_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>

#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL::Intrinsic_triangulations {

/// How to solve linear problems.
enum class Linear_solver {
  automatic, ///< as `solver_for()` says; by a factorization where an iteration does not converge
  direct,    ///< by a factorization, accurate up to rounding
  iterative  ///< by `Multigrid_factorization`: in less memory, with a residual of 1e-10
};

/// returns the solver that is named "auto", "direct" or "iterative".
/// \throws std::invalid_argument if there is none of that name
inline Linear_solver solver_named(std::string_view name) {
  if (name == "auto") return Linear_solver::automatic;
  if (name == "direct") return Linear_solver::direct;
  if (name == "iterative") return Linear_solver::iterative;
  throw std::invalid_argument("there is no solver " + std::string(name) +
                              "; give auto, direct or iterative");
}

/*!
\brief chooses a solver for the Laplacian of a surface by its size: factors take time by the power
3/2 of the number of rows, iterations linear time for each right side.

\param rows the number of rows of the matrix
\param right_sides how many problems are solved with it. Default: any number
\return `iterative` from a million rows on, if at most sqrt(rows) / 300 right sides make it faster;
  and always beyond five million rows, where factors do not fit into usual memories. The page
  [Solving](@ref page_solving) has the measurements.
*/
inline Linear_solver
solver_for(Eigen::Index rows, Eigen::Index right_sides = std::numeric_limits<Eigen::Index>::max()) {
  constexpr Eigen::Index worth_less_digits = 1'000'000, greatest_factored = 5'000'000;
  if (rows > greatest_factored) return Linear_solver::iterative;
  const bool are_few =
      static_cast<double>(right_sides) <= std::sqrt(static_cast<double>(rows)) / 300;
  return rows >= worth_less_digits && are_few ? Linear_solver::iterative : Linear_solver::direct;
}

namespace internal {

// What is asked for, or what the rule says if nothing is.
inline Linear_solver
chosen_solver(Linear_solver asked, Eigen::Index rows,
              Eigen::Index right_sides = std::numeric_limits<Eigen::Index>::max()) {
  return asked == Linear_solver::automatic ? solver_for(rows, right_sides) : asked;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_LINEAR_SOLVER_H
