// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_FACTORED_LAPLACIAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_FACTORED_LAPLACIAN_H

#include <CGAL/Intrinsic_triangulations/operators/Connection_graph.h>
#include <CGAL/Intrinsic_triangulations/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/raised_factorization.h>

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

// Factors `shift` + `factor` L.
template <class Scalar>
Cholesky_factorization<Scalar> factored_laplacian(const Connection_graph& graph, int order,
                                                  double factor, const std::vector<double>& shift) {
  Eigen::SparseMatrix<Scalar> m = shifted_laplacian<Scalar>(graph, order, factor, shift);
  return raised_factorization(m);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_FACTORED_LAPLACIAN_H
