// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_CHOSEN_FACTORIZATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_CHOSEN_FACTORIZATION_H

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Multigrid_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <concepts>
#include <functional>
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

// Of a matrix that is positive definite up to rounding; see `raised_factorization()`.
template <Matrix_number Scalar>
Chosen_factorization<Scalar> chosen_factorization(Eigen::SparseMatrix<Scalar> m,
                                                  Linear_solver solver) {
  if (chosen_solver(solver, m.cols()) == Linear_solver::iterative)
    return Chosen_factorization<Scalar>(Multigrid_factorization<Scalar>(m));
  return Chosen_factorization<Scalar>(raised_factorization(m));
}

// Of the Laplacian of a graph and a diagonal, see `Laplacian_factorization`.
inline Chosen_factorization<double>
chosen_factorization(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& diagonal,
                     Linear_solver solver) {
  if (chosen_solver(solver, laplacian.cols()) == Linear_solver::iterative)
    return Chosen_factorization<double>(Multigrid_factorization<double>(laplacian, diagonal));
  return Chosen_factorization<double>(Laplacian_factorization(laplacian, diagonal));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_CHOSEN_FACTORIZATION_H
