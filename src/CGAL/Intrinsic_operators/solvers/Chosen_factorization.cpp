// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Multigrid_factorization.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

Chosen_factorization<double> chosen_factorization(Eigen::SparseMatrix<double> laplacian,
                                                  Eigen::VectorXd diagonal, Linear_solver solver) {
  const auto shared =
      std::make_shared<const std::pair<Eigen::SparseMatrix<double>, Eigen::VectorXd>>(
          std::move(laplacian), std::move(diagonal));
  return chosen_factorization<double>(
      shared->first.cols(), solver,
      [&] { return Multigrid_factorization<double>(shared->first, shared->second); },
      [shared] {
        return Chosen_factorization<double>(Laplacian_factorization(shared->first, shared->second));
      });
}

template Chosen_factorization<double> chosen_factorization(Eigen::SparseMatrix<double>,
                                                           Linear_solver);

} // namespace CGAL::Intrinsic_triangulations::internal
