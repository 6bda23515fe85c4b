// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_DIRECTION_PROBLEM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_DIRECTION_PROBLEM_H

#include <CGAL/Intrinsic_triangulations/operators/Connection_graph.h>

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// What a direction field is asked for, in powers of its directions.
struct Direction_problem {
  int degree;
  Eigen::VectorXcd guide; // what to be near, zero where there is no wish
  double strength;        // of that, in multiples of 1 / squared mean length of edges
  std::vector<std::pair<std::size_t, std::complex<double>>> fixed;
};

// The smoothest field, its values of length 1; zero at isolated vertices.
std::vector<std::complex<double>> solve(const Direction_problem& problem,
                                        const Connection_graph& graph);

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/applications/vectors/Direction_problem_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_DIRECTION_PROBLEM_H
