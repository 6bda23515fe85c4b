// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_MINIMUM_DEGREE_ORDER_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_MINIMUM_DEGREE_ORDER_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Whether Eigen orders a matrix by `int`, with all of its diagonal stored. It adds up numbers of
// rows, at most as many as a column has entries, of columns with up to 10 sqrt(n) of them (others
// come last). Where that sum overflows, Eigen 3.4 reads and writes beyond its arrays: around hubs
// of large matrices. Rows without a diagonal entry come last, in their own order.
template <class Scalar>
bool is_ordered_by_int(const Eigen::SparseMatrix<Scalar>& a) {
  int most = 0;
  for (int c = 0; c < a.cols(); ++c) {
    const int* const begin = a.innerIndexPtr() + a.outerIndexPtr()[c];
    const int* const end = a.innerIndexPtr() + a.outerIndexPtr()[c + 1];
    if (!std::binary_search(begin, end, c)) return false;
    most = std::max(most, static_cast<int>(end - begin));
  }
  const auto n = static_cast<double>(a.cols());
  return std::min<double>(most, 10 * std::sqrt(n)) * n <= std::numeric_limits<int>::max();
}

using Wide_pattern = Eigen::SparseMatrix<signed char, Eigen::ColMajor, std::int64_t>;

// The places of the entries of a matrix, and those of its diagonal.
template <class Scalar>
Wide_pattern pattern_with_diagonal(const Eigen::SparseMatrix<Scalar>& a) {
  Wide_pattern result(a.rows(), a.cols());
  result.resizeNonZeros(a.nonZeros() + a.cols());
  std::int64_t* to = result.innerIndexPtr();
  for (int c = 0; c < a.cols(); ++c) {
    const int *const begin = a.innerIndexPtr() + a.outerIndexPtr()[c],
                     *const end = a.innerIndexPtr() + a.outerIndexPtr()[c + 1],
                     *const at = std::lower_bound(begin, end, c);
    to = std::copy(begin, at, to);
    *to++ = c;
    to = std::copy(at != end && *at == c ? at + 1 : at, end, to);
    result.outerIndexPtr()[c + 1] = to - result.innerIndexPtr();
  }
  result.resizeNonZeros(to - result.innerIndexPtr());
  std::fill_n(result.valuePtr(), result.nonZeros(), static_cast<signed char>(1));
  return result;
}

template <class Matrix>
std::vector<int> order_of_eigen(const Matrix& a) {
  using Index = typename Matrix::StorageIndex;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> p;
  Eigen::AMDOrdering<Index>()(a.template selfadjointView<Eigen::Lower>(), p);
  return {p.indices().data(), p.indices().data() + p.indices().size()};
}

// The rows of a symmetric matrix, as an approximate minimum degree orders them.
// \param a compressed, with sorted rows; the lower triangle is read
template <class Scalar>
std::vector<int> minimum_degree_order(const Eigen::SparseMatrix<Scalar>& a) {
  if (a.cols() == 0) return {};
  return is_ordered_by_int(a) ? order_of_eigen(a) : order_of_eigen(pattern_with_diagonal(a));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ORDERING_MINIMUM_DEGREE_ORDER_H
