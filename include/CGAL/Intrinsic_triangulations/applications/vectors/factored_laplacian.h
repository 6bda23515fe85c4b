// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_FACTORED_LAPLACIAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_FACTORED_LAPLACIAN_H

#include <CGAL/Intrinsic_triangulations/operators/Connection_graph.h>
#include <CGAL/Intrinsic_triangulations/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Cholesky_factorization.h>

#include <Eigen/SparseCore>

#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The areas at vertices, ones at isolated vertices.
inline std::vector<double> positive_masses(const Connection_graph& graph) {
  std::vector<double> masses = graph.areas;
  for (double& m : masses)
    if (!(m > 0)) m = 1;
  return masses;
}

// Factors `shift` + `factor` L, after `change(matrix)`. Where weights are so large that rounding has lost the shift, the diagonal is raised by a part of it
// that is in the order of rounding errors.
template <class Scalar, class Change>
Cholesky_factorization<Scalar> factored_laplacian(const Connection_graph& graph, int order,
                                                  double factor, const std::vector<double>& shift,
                                                  const Change& change) {
  Eigen::SparseMatrix<Scalar> m = shifted_laplacian<Scalar>(graph, order, factor, shift);
  change(m);
  for (double raise = 0x1p-48; raise < 0x1p-20; raise *= 0x1p8) {
    try {
      return Cholesky_factorization<Scalar>(m);
    } catch (const Indefinite_matrix&) {
      for (int i = 0; i < m.cols(); ++i) m.coeffRef(i, i) *= 1 + raise;
    }
  }
  return Cholesky_factorization<Scalar>(m);
}

template <class Scalar>
Cholesky_factorization<Scalar> factored_laplacian(const Connection_graph& graph, int order,
                                                  double factor, const std::vector<double>& shift) {
  return factored_laplacian<Scalar>(graph, order, factor, shift,
                                    [](Eigen::SparseMatrix<Scalar>&) {});
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_FACTORED_LAPLACIAN_H
