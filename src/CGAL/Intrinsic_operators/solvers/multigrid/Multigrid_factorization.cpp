// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Multigrid_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/multigrid/Multigrid.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

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

template std::shared_ptr<const Multigrid<double>> make_multigrid(const Eigen::SparseMatrix<double>&,
                                                                 const Eigen::VectorXd&, double);

} // namespace internal

No_convergence::No_convergence(const Iterations& iterations)
    : std::runtime_error(internal::message_of(iterations)), iterations_(iterations) {}

template class Multigrid_factorization<double>;

} // namespace CGAL::Intrinsic_triangulations
