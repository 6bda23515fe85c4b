// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Row_sums::Row_sums(const Eigen::SparseMatrix<double>& a)
    : sum(Eigen::VectorXd::Zero(a.rows())), bound(sum) {
  Eigen::VectorXd count = sum;
  for (int c = 0; c < a.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, c); i; ++i) {
      sum[i.row()] += i.value();
      bound[i.row()] += std::abs(i.value());
      count[i.row()] += 1;
    }
  bound = 0x1p-52 * count.cwiseProduct(bound); // n 2^-53 of these sums, twice
}

std::vector<char> laplacian_components(const Row_sums& sums,
                                       const std::vector<std::uint32_t>& component) {
  return components_where_all(component, [&](Eigen::Index r) { return sums.may_be_zero(r); });
}

std::vector<char> marked_rows(Eigen::Index size, std::span<const std::uint32_t> rows) {
  std::vector<char> result(row_number(size), 0);
  for (const std::uint32_t r : rows) {
    if (r >= result.size())
      throw std::invalid_argument("there is no row " + std::to_string(r) + ": the matrix has " +
                                  std::to_string(size) + "; give smaller numbers");
    result[r] = 1;
  }
  return result;
}

std::vector<std::uint32_t> least_rows(const std::vector<std::uint32_t>& component,
                                      const std::vector<char>& is_marked) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t r = 0; r < component.size(); ++r)
    if (component[r] == r && is_marked[r] != 0) rows.push_back(r);
  return rows;
}

bool is_laplacian(const Eigen::SparseMatrix<double>& a) {
  const Row_sums sums(a);
  return (sums.sum.array().abs() <= sums.bound.array()).all();
}

bool has_no_positive_entry_off_diagonal(const Eigen::SparseMatrix<double>& a) {
  for (int c = 0; c < a.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, c); i; ++i)
      if (i.value() > 0 && i.row() != c) return false;
  return true;
}

Eigen::VectorXd diagonal_with_fixed_rows(const Eigen::SparseMatrix<double>& laplacian,
                                         Eigen::VectorXd diagonal,
                                         const std::vector<char>& is_fixed) {
  for (int c = 0; c < laplacian.cols(); ++c)
    if (is_fixed[static_cast<std::size_t>(c)] != 0)
      for (Eigen::SparseMatrix<double>::InnerIterator i(laplacian, c); i; ++i)
        diagonal[i.row()] -= i.value();
  for (Eigen::Index r = 0; r < diagonal.size(); ++r)
    if (is_fixed[static_cast<std::size_t>(r)] != 0) diagonal[r] = 1;
  return diagonal;
}

} // namespace CGAL::Intrinsic_triangulations::internal
