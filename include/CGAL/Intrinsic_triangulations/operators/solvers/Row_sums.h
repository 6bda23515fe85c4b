// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ROW_SUMS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ROW_SUMS_H

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Sums of the rows of a symmetric matrix, and what rounding may make of them where they are zero: of the entries on the diagonal, which were
// summed, and of the sums.
struct Row_sums {
  explicit Row_sums(const Eigen::SparseMatrix<double>& a)
      : sum(Eigen::VectorXd::Zero(a.rows())), bound(sum) {
    Eigen::VectorXd count = sum;
    for (int c = 0; c < a.outerSize(); ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator i(a, c); i; ++i) {
        sum[i.row()] += i.value();
        bound[i.row()] += std::abs(i.value());
        count[i.row()] += 1;
      }
    bound = 0x1p-52 * count.cwiseProduct(bound);
  }
  bool may_be_zero(Eigen::Index row) const { return std::abs(sum[row]) <= bound[row]; }

  Eigen::VectorXd sum, bound;
};

// Marks the components, at their least rows, of which all rows may sum to zero.
inline std::vector<char> laplacian_components(const Row_sums& sums,
                                              const std::vector<std::uint32_t>& component) {
  std::vector<char> result(component.size(), 1);
  for (std::size_t r = 0; r < component.size(); ++r)
    if (!sums.may_be_zero(static_cast<Eigen::Index>(r))) result[component[r]] = 0;
  return result;
}

// Whether all rows may sum to zero.
inline bool is_laplacian(const Eigen::SparseMatrix<double>& a) {
  const Row_sums sums(a);
  for (Eigen::Index r = 0; r < a.rows(); ++r)
    if (!sums.may_be_zero(r)) return false;
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ROW_SUMS_H
