// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_DIRECTION_PROBLEM_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_DIRECTION_PROBLEM_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// What takes long of a direction field.
enum class Direction_step {
  factored, ///< the matrix was factored
  improved  ///< eigenvectors were improved, by some solutions; of fields without wishes, some times
};

namespace internal {

// What a direction field is asked for, in powers of its directions.
struct Direction_problem {
  int degree;
  Eigen::VectorXcd guide; // what to be near, zero where there is no wish
  double strength;        // of that, in multiples of 1 / squared mean length of edges
  std::vector<std::pair<std::size_t, std::complex<double>>> fixed;
};

// The smoothest field, its values of length 1; zero at isolated vertices. Nothing if it was
// cancelled.
std::vector<std::complex<double>> solve(const Direction_problem& problem,
                                        const Connection_graph& graph,
                                        const std::function<bool(Direction_step)>& progress);

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_DIRECTION_PROBLEM_H
