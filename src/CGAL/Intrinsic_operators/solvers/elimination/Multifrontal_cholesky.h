// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_MULTIFRONTAL_CHOLESKY_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_MULTIFRONTAL_CHOLESKY_H

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/elimination/Multifrontal_elimination.h>
#include <CGAL/Intrinsic_operators/solvers/elimination/Multifrontal_factor.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Symbolic_factorization.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <memory>
#include <stdexcept>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

template <class Scalar>
void expect_factorable(const Eigen::SparseMatrix<Scalar>& a) {
  if (a.rows() != a.cols())
    throw std::invalid_argument("a matrix with " + std::to_string(a.rows()) + " rows and " +
                                std::to_string(a.cols()) + " columns cannot be factored");
  for (int c = 0; c < a.outerSize(); ++c)
    for (typename Eigen::SparseMatrix<Scalar>::InnerIterator i(a, c); i; ++i)
      if (!std::isfinite(std::real(i.value())) || !std::isfinite(std::imag(i.value())))
        throw std::invalid_argument("the matrix must be finite, but entry (" +
                                    std::to_string(i.row()) + ", " + std::to_string(c) +
                                    ") is not");
}

// The factor by fronts.
template <class Scalar>
class Multifrontal_cholesky : public Cholesky_factor<Scalar> {
public:
  using Vectors = typename Cholesky_factor<Scalar>::Vectors;

  // \param a compressed, both triangles of it
  Multifrontal_cholesky(const Eigen::SparseMatrix<Scalar>& a, const Shared_analysis& analysis)
      : factor_(analysis) {
    Multifrontal_elimination(*analysis, Self_adjoint_arithmetic(factor_, a)).eliminate();
  }

  Vectors solve(const Vectors& b) const override { return factor_.solve(b); }

private:
  Multifrontal_factor<Scalar> factor_;
};

template <class Scalar>
std::shared_ptr<const Cholesky_factor<Scalar>> factor_fronts(const Eigen::SparseMatrix<Scalar>& a,
                                                             Shared_analysis& analysis) {
  analyze(a, analysis);
  return std::make_shared<const Multifrontal_cholesky<Scalar>>(a, analysis);
}

template <class Scalar>
std::shared_ptr<const Cholesky_factor<Scalar>>
factor_lower_triangle(const Eigen::SparseMatrix<Scalar>& a) {
  expect_factorable(a);
  Eigen::SparseMatrix<Scalar> full = a.template selfadjointView<Eigen::Lower>();
  full.makeCompressed();
  Shared_analysis none;
  return factor_fronts(full, none);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_MULTIFRONTAL_CHOLESKY_H
