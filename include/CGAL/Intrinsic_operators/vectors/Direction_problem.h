// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_DIRECTION_PROBLEM_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_DIRECTION_PROBLEM_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// A long step of the computation of a direction field.
enum class Direction_step {
  factored, ///< the matrix is factored
  improved  ///< eigenvectors are better by a solution; repeated for fields without a guide
};

namespace internal {

// The constraints of a direction field, in powers of its directions.
struct Direction_problem {
  int degree;
  Eigen::VectorXcd guide; // the wanted direction, zero if there is none
  double strength;        // of the guide, in multiples of 1 / squared mean length of edges
  std::vector<std::pair<std::size_t, std::complex<double>>> fixed;
  Linear_solver solver = Linear_solver::automatic;
};

// The smoothest field, its values of length 1; zero at isolated vertices. Empty if cancelled.
std::vector<std::complex<double>> solve(const Direction_problem& problem,
                                        const Connection_graph& graph,
                                        const std::function<bool(Direction_step)>& progress);

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_DIRECTION_PROBLEM_H
