// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_RAISED_FACTORIZATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_RAISED_FACTORIZATION_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/Cholesky_factorization.h>

#include <Eigen/SparseCore>

namespace CGAL::Intrinsic_triangulations::internal {

// Factors a matrix that would be positive definite, were there no rounding. Where weights are so large that it has lost the masses beside
// them, the diagonal is raised, also in `m`, by a part of it in the order of rounding errors: 2^-40 at most, which needles and caps of 10^-15 need.
template <class Scalar>
Cholesky_factorization<Scalar> raised_factorization(Eigen::SparseMatrix<Scalar>& m) {
  for (const double raise : {0x1p-48, 0x1p-40}) {
    try {
      return Cholesky_factorization<Scalar>(m);
    } catch (const Indefinite_matrix&) {
      for (int i = 0; i < m.cols(); ++i) m.coeffRef(i, i) *= 1 + raise;
    }
  }
  try {
    return Cholesky_factorization<Scalar>(m);
  } catch (const Indefinite_matrix& error) {
    throw Indefinite_matrix(
        error.row(), "weights there differ by more than doubles hold; refine the triangulation, "
                     "or mollify the mesh");
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_RAISED_FACTORIZATION_H
