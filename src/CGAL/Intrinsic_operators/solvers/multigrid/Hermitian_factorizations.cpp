// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Multigrid_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/elimination/Multifrontal_cholesky.h>
#include <CGAL/Intrinsic_operators/solvers/multigrid/Iteration_or_factor.h>
#include <CGAL/Intrinsic_operators/solvers/multigrid/Multigrid.h>

#include <Eigen/SparseCore>

#include <complex>
#include <memory>

// What complex matrices need, and the first library does not.

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template void expect_factorable(const Eigen::SparseMatrix<std::complex<double>>&);

std::shared_ptr<const Cholesky_factor<std::complex<double>>>
make_cholesky_factor(const Eigen::SparseMatrix<std::complex<double>>& a) {
  return factor_lower_triangle(a);
}

std::shared_ptr<const Cholesky_factor<std::complex<double>>>
make_cholesky_factor(const Eigen::SparseMatrix<std::complex<double>>& a,
                     Shared_analysis& analysis) {
  expect_factorable(a);
  return factor_fronts(a, analysis);
}

} // namespace internal

template class Multigrid_factorization<std::complex<double>>;
template class internal::Iteration_or_factor<std::complex<double>>;

} // namespace CGAL::Intrinsic_triangulations
