// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_ITERATION_OR_FACTOR_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_ITERATION_OR_FACTOR_H

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Multigrid_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

template <Matrix_number Scalar>
struct Iteration_or_factor<Scalar>::Shared {
  Shared(Multigrid_factorization<Scalar> i, std::function<Chosen_factorization<Scalar>()> f)
      : iteration(std::move(i)), factored(std::move(f)) {}

  Multigrid_factorization<Scalar> iteration;
  std::function<Chosen_factorization<Scalar>()> factored;
  std::mutex mutex; // of the thread that factors
  std::atomic<bool> is_factored = false;
  std::optional<Chosen_factorization<Scalar>> factor;
};

template <Matrix_number Scalar>
Iteration_or_factor<Scalar>::Iteration_or_factor(
    Multigrid_factorization<Scalar> iteration,
    std::function<Chosen_factorization<Scalar>()> factored)
    : shared_(std::make_shared<Shared>(std::move(iteration), std::move(factored))) {}

template <Matrix_number Scalar>
Eigen::Index Iteration_or_factor<Scalar>::size() const {
  return shared_->iteration.size();
}

template <Matrix_number Scalar>
typename Iteration_or_factor<Scalar>::Vectors
Iteration_or_factor<Scalar>::solve(const Vectors& b) const {
  if (!shared_->is_factored) {
    try {
      return shared_->iteration.solve(b);
    } catch (const No_convergence&) {
    } catch (const Indefinite_matrix&) { // of negative weights
    }
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    if (!shared_->is_factored) {
      shared_->factor.emplace(shared_->factored());
      shared_->is_factored = true;
    }
  }
  return shared_->factor->solve(b);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_ITERATION_OR_FACTOR_H
