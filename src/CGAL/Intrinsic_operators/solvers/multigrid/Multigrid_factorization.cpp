// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Multigrid_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/multigrid/Iteration_or_factor.h>
#include <CGAL/Intrinsic_operators/solvers/multigrid/Multigrid.h>

#include <sstream>
#include <stdexcept>
#include <string>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

static std::string message_of(const Iterations& iterations) {
  std::ostringstream message;
  message << "the iteration ended after " << iterations.most << " steps with a residual of "
          << iterations.residual
          << "; factor the matrix (a direct solver), "
             "or make the triangulation Delaunay";
  return message.str();
}

} // namespace internal

No_convergence::No_convergence(const Iterations& iterations)
    : std::runtime_error(internal::message_of(iterations)), iterations_(iterations) {}

template class Multigrid_factorization<double>;
template class internal::Iteration_or_factor<double>;

} // namespace CGAL::Intrinsic_triangulations
