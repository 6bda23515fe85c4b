// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_CHOSEN_FACTORIZATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_CHOSEN_FACTORIZATION_H

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Multigrid_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <concepts>
#include <functional>
#include <memory>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// A matrix that is ready for right sides, by the solver that was chosen when it was seen. A model
// of `Factorization`.
template <Matrix_number Scalar>
class Chosen_factorization {
public:
  using Matrix = Eigen::SparseMatrix<Scalar>;
  using Vectors = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  // \tparam Factored a model of `Factorization`. Its concept would ask whether this class is
  // copyable, and so whether this constructor copies.
  template <class Factored>
    requires(!std::same_as<Factored, Chosen_factorization>)
  explicit Chosen_factorization(Factored f)
      : size_(f.size()),
        solve_([f = std::move(f)](const Vectors& b) -> Vectors { return f.solve(b); }) {}

  Eigen::Index size() const { return size_; }
  Vectors solve(const Vectors& b) const { return solve_(b); }

private:
  Eigen::Index size_;
  std::function<Vectors(const Vectors&)> solve_;
};

// Iterates; from the first right side on for which that does not converge, factors. A model of
// `Factorization`; copies share everything.
template <Matrix_number Scalar>
class Iteration_or_factor {
public:
  using Vectors = typename Chosen_factorization<Scalar>::Vectors;

  Iteration_or_factor(Multigrid_factorization<Scalar> iteration,
                      std::function<Chosen_factorization<Scalar>()> factored);

  Eigen::Index size() const;
  Vectors solve(const Vectors& b) const;

private:
  struct Shared;

  std::shared_ptr<Shared> shared_;
};

// \param prepared returns the `Multigrid_factorization`, factored() the `Chosen_factorization` of a
// factor; it is kept, and called later, only if the choice is automatic
template <Matrix_number Scalar, class Prepared, class Factored>
Chosen_factorization<Scalar> chosen_factorization(Eigen::Index rows, Linear_solver solver,
                                                  const Prepared& prepared, Factored factored) {
  if (solver == Linear_solver::iterative) return Chosen_factorization<Scalar>(prepared());
  if (chosen_solver(solver, rows) == Linear_solver::direct) return factored();
  try {
    return Chosen_factorization<Scalar>(Iteration_or_factor<Scalar>(prepared(), factored));
  } catch (const Indefinite_matrix&) { // of negative weights
    return factored();
  }
}

// Of a matrix that is positive definite up to rounding; see `raised_factorization()`.
template <Matrix_number Scalar>
Chosen_factorization<Scalar> chosen_factorization(Eigen::SparseMatrix<Scalar> m,
                                                  Linear_solver solver) {
  const auto shared = std::make_shared<Eigen::SparseMatrix<Scalar>>(std::move(m));
  return chosen_factorization<Scalar>(
      shared->cols(), solver, [&] { return Multigrid_factorization<Scalar>(*shared); },
      [shared] { return Chosen_factorization<Scalar>(raised_factorization(*shared)); });
}

// Of the Laplacian of a graph and a diagonal, see `Laplacian_factorization`.
Chosen_factorization<double> chosen_factorization(Eigen::SparseMatrix<double> laplacian,
                                                  Eigen::VectorXd diagonal, Linear_solver solver);

extern template Chosen_factorization<double> chosen_factorization(Eigen::SparseMatrix<double>,
                                                                  Linear_solver);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_CHOSEN_FACTORIZATION_H
