// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/elimination/Multifrontal_cholesky.h>

#include <Eigen/SparseCore>

#include <memory>

namespace CGAL::Intrinsic_triangulations::internal {

template void expect_factorable(const Eigen::SparseMatrix<double>&);

std::shared_ptr<const Cholesky_factor<double>>
make_cholesky_factor(const Eigen::SparseMatrix<double>& a) {
  return factor_lower_triangle(a);
}

} // namespace CGAL::Intrinsic_triangulations::internal
