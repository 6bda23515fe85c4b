// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_RAISED_FACTORIZATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_RAISED_FACTORIZATION_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/Cholesky_factorization.h>

#include <Eigen/SparseCore>

namespace CGAL::Intrinsic_triangulations::internal {

// Factors a matrix that would be positive definite, were there no rounding. Where weights are so large that it has lost the masses beside
// them, the diagonal is raised by as small a part of it as it takes, also in `m`: as a rule in the order of rounding errors.
template <class Scalar>
Cholesky_factorization<Scalar> raised_factorization(Eigen::SparseMatrix<Scalar>& m) {
  for (double raise = 0x1p-48; raise < 0x1p-10; raise *= 0x1p8) {
    try {
      return Cholesky_factorization<Scalar>(m);
    } catch (const Indefinite_matrix&) {
      for (int i = 0; i < m.cols(); ++i) m.coeffRef(i, i) *= 1 + raise;
    }
  }
  return Cholesky_factorization<Scalar>(m);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_RAISED_FACTORIZATION_H
