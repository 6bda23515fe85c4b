// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_UNEVEN_LAPLACIANS_H
#define TEST_INTRINSIC_TRIANGULATIONS_UNEVEN_LAPLACIANS_H

#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

/// Laplacians whose weights span many orders of magnitude, and numbers for the results.
namespace uneven_laplacians {

using Precise = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                              boost::multiprecision::et_off>;

/// returns the Laplacian of a square grid and positive masses: a fifth of the weights is from 1 to `greatest`, by powers; others, and masses, are about 1.
inline std::pair<Eigen::SparseMatrix<double>, Eigen::SparseMatrix<double>>
uneven_grid(int n, double greatest) {
  std::mt19937 random(7);
  const auto uniform = [&random] { return static_cast<double>(random()) * 0x1p-32; };
  std::vector<CGAL::Intrinsic_triangulations::Symmetric_entry> entries;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(n * n), mass = sum;
  const auto join = [&](int i, int j) {
    const double w = random() % 5 == 0 ? std::pow(greatest, uniform()) : 0.5 + uniform();
    entries.push_back({i, j, -w});
    sum[i] += w;
    sum[j] += w;
  };
  for (int i = 0; i < n * n; ++i) {
    mass[i] = 0.5 + uniform();
    if (i % n + 1 < n) join(i, i + 1);
    if (i + n < n * n) join(i, i + n);
  }
  using CGAL::Intrinsic_triangulations::symmetric_matrix;
  return {symmetric_matrix(entries, sum), symmetric_matrix({}, mass)};
}

} // namespace uneven_laplacians

#endif // TEST_INTRINSIC_TRIANGULATIONS_UNEVEN_LAPLACIANS_H
