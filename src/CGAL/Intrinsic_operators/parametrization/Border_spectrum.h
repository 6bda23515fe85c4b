// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_BORDER_SPECTRUM_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_BORDER_SPECTRUM_H

#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs/Inverse_lanczos.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

using Complex_matrix = Eigen::SparseMatrix<std::complex<double>>;

// Isolated vertices get the value zero.
inline void regularise_isolated(Complex_matrix& c) {
  for (int r = 0; r < c.cols(); ++r)
    if (c.coeff(r, r) == 0.0) c.coeffRef(r, r) = 1;
  c.makeCompressed();
}

// The eigenvector of C w = lambda B w with the least eigenvalue but that of constants, where B has
// the shares of border vertices in its length. A small multiple of B shifts C, since C may be
// singular: on a flat surface its own shape has eigenvalue zero. (Holomorphic functions have no
// conformal energy: the least eigenvalues are those of the smoothest ones, in the order of squared
// lengths of edges.)
// `progress` returns whether to go on, after each solution; the result is empty if not.
inline Eigen::VectorXcd first_of_border_spectrum(Complex_matrix c, const Disk_border& border,
                                                 const std::function<bool()>& progress) {
  constexpr double shift = 1e-9; // added to all eigenvalues; changes no eigenvector but by rounding
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(c.rows()); // sums to 1
  const double around = std::accumulate(border.lengths.begin(), border.lengths.end(), 0.0);
  const std::size_t n = border.rows.size();
  for (std::size_t k = 0; k < n; ++k)
    weight[border.rows[k]] = (border.lengths[k] + border.lengths[(k + n - 1) % n]) / (2 * around);
  regularise_isolated(c);
  Eigen::VectorXcd start(c.rows()); // not orthogonal to any eigenvector
  for (Eigen::Index r = 0; r < c.rows(); ++r) {
    if (weight[r] > 0) c.coeffRef(r, r) += shift * weight[r];
    start[r] = std::polar(weight[r], static_cast<double>(r) + static_cast<double>(r * r));
  }
  const Chosen_factorization<std::complex<double>> factored(raised_factorization(c));
  start = factored.solve(start);
  if (!progress()) return {};
  return Inverse_lanczos(factored, weight, std::vector<std::uint32_t>(row_number(c.rows()), 0),
                         Eigen::MatrixXcd::Ones(c.rows(), 1))
      .smallest(start, progress);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_BORDER_SPECTRUM_H
