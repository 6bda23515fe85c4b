// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "application.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs.h>

#include <algorithm>
#include <string>

namespace program {

namespace {

// The lumped mass of an isolated vertex is zero. With any positive mass instead, it only has a
// function that is zero elsewhere.
Eigen::SparseMatrix<double> positive_mass(Eigen::SparseMatrix<double> m) {
  const double mean = m.diagonal().sum() / static_cast<double>(std::max<Eigen::Index>(m.rows(), 1));
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    if (!(m.coeff(i, i) > 0)) m.coeffRef(i, i) = mean;
  return m;
}

Computed eigenfunctions(const Eigen::SparseMatrix<double>& laplacian,
                        const Eigen::SparseMatrix<double>& mass, std::size_t count) {
  const auto n = std::min(static_cast<Eigen::Index>(count), laplacian.rows());
  const IT::Eigenpairs pairs = IT::smallest_eigenpairs(laplacian, positive_mass(mass), n);
  Computed computed{"eigen", {}, {}};
  computed.json = {{"count", n},
                   {"values", std::vector<double>(pairs.values.begin(), pairs.values.end())}};
  computed.isolines = 20;
  computed.shown = n > 1 ? 1 : 0; // the first is constant
  for (Eigen::Index k = 0; k < n; ++k)
    computed.functions.push_back({"eigenfunction_" + std::to_string(k), pairs.vectors.col(k)});
  return computed;
}

} // namespace

void run_eigen(const Options& options) {
  run_application(options, [&](const auto& t, const Sources&, const Points&, Progress&) {
    return eigenfunctions(IT::cotangent_laplacian(t), IT::lumped_mass_matrix(t),
                          options.application.count);
  });
}

} // namespace program
