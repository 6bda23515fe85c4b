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
          << iterations.residual << "; factor the matrix, or make the triangulation Delaunay";
  return message.str();
}

std::shared_ptr<const Multigrid<double>>
make_multigrid(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& diagonal,
               double tolerance) {
  expect_factorable(laplacian);
  expect_tolerance(tolerance);
  if (diagonal.size() != laplacian.rows() || !diagonal.allFinite())
    throw std::invalid_argument("the diagonal must have a finite number per row of the matrix");
  Eigen::SparseMatrix<double> full = laplacian.selfadjointView<Eigen::Lower>();
  const Eigen::VectorXd sums = full * Eigen::VectorXd::Ones(full.cols());
  for (int i = 0; i < full.cols(); ++i) full.coeffRef(i, i) += diagonal[i] - sums[i];
  full.makeCompressed();
  return std::make_shared<const Multigrid<double>>(std::move(full), diagonal, tolerance);
}

} // namespace internal

No_convergence::No_convergence(const Iterations& iterations)
    : std::runtime_error(internal::message_of(iterations)), iterations_(iterations) {}

template class Multigrid_factorization<double>;

} // namespace CGAL::Intrinsic_triangulations
