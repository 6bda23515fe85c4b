// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Eigen::SparseMatrix<double> symmetric_matrix(const std::vector<Symmetric_entry>& entries,
                                             const Eigen::VectorXd& diagonal) {
  return internal::Symmetric_columns<>(entries, static_cast<int>(diagonal.size()))
      .matrix([&](int c, auto) { return diagonal[c]; });
}

namespace internal {

Eigen::SparseMatrix<std::complex<double>>
hermitian_matrix(const std::vector<Hermitian_entry>& entries, const Eigen::VectorXd& diagonal) {
  return Symmetric_columns<std::complex<double>>(entries, static_cast<int>(diagonal.size()))
      .matrix([&](int c, auto) { return diagonal[c]; });
}

void expect_countable(std::uint64_t number, const std::string& has) {
  if (number > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
    throw Invalid_input(Element_kind::none, 0,
                        has + ", more than Eigen's index type can count; split the mesh");
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
