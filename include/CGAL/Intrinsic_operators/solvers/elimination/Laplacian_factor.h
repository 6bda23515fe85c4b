// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_FACTOR_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_FACTOR_H

#include <CGAL/Intrinsic_operators/solvers/elimination/Symbolic_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/elimination/row_number.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The sum of the terms m to m + n - 1.
template <std::size_t n, class Term>
auto sum_in_pairs(const Term& term, std::size_t m = 0) {
  if constexpr (n == 1)
    return term(m);
  else
    return decltype(term(m))(sum_in_pairs<n / 2>(term, m) + sum_in_pairs<n / 2>(term, m + n / 2));
}

// The factor of a Laplacian and a diagonal: unit triangular, minus `value` below the diagonal,
// times the pivots, times its transpose.
struct Laplacian_factor {
  // leaves the numbers to be written
  explicit Laplacian_factor(std::shared_ptr<const Symbolic_factorization> s)
      : symbolic(std::move(s)),
        value(std::make_unique_for_overwrite<double[]>(row_number(symbolic->column_begin.back()))),
        pivot(symbolic->row.size()) {}

  // Solves for the columns of b from c on, as many as a pack holds, and writes those of x.
  template <int right_sides>
  void solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::MatrixXd& x, Eigen::Index c) const {
    using Pack = Eigen::Array<double, right_sides, 1>;
    std::vector<Pack> y(pivot.size());
    for (std::size_t k = 0; k < y.size(); ++k)
      y[k] = b.block<1, right_sides>(symbolic->row[k], c).transpose();
    for (int s = 0; s < symbolic->supernodes(); ++s) solve_forward(s, y.data());
    for (int s = symbolic->supernodes() - 1; s >= 0; --s) solve_backward(s, y.data());
    for (std::size_t k = 0; k < y.size(); ++k)
      x.block<1, right_sides>(symbolic->row[k], c) = y[k].matrix().transpose();
  }

  std::shared_ptr<const Symbolic_factorization> symbolic;
  std::unique_ptr<double[]> value; // not a vector, which would write megabytes of zeros first
  std::vector<double> pivot;       // by places

private:
  const double* column(int k) const { return value.get() + symbolic->column_begin[row_number(k)]; }

  template <class Pack>
  void solve_forward(int s, Pack* y) const {
    const int begin = symbolic->supernode_begin[row_number(s)], end = begin + symbolic->columns(s);
    for (int j = begin; j < end; ++j)
      for (int i = j + 1; i < end; ++i) y[i] += column(j)[i - j - 1] * y[j];
    int j = begin;
    for (; j + 4 <= end; j += 4) add_below<4>(s, j, y);
    for (; j < end; ++j) add_below<1>(s, j, y);
  }

  template <class Pack>
  void solve_backward(int s, Pack* y) const {
    const int begin = symbolic->supernode_begin[row_number(s)], end = begin + symbolic->columns(s);
    for (int j = begin; j < end; ++j) y[j] /= pivot[row_number(j)];
    int j = begin;
    for (; j + 4 <= end; j += 4) add_from_below<4>(s, j, y);
    for (; j < end; ++j) add_from_below<1>(s, j, y);
    for (int k = end - 2; k >= begin; --k)
      for (int i = k + 1; i < end; ++i) y[k] += column(k)[i - k - 1] * y[i];
  }

  // Some columns of a supernode from j on at once: below it they have entries in the same rows,
  // which are scattered.
  template <int columns, class Pack>
  void add_below(int s, int j, Pack* y) const {
    if (std::all_of(y + j, y + j + columns, [](const Pack& p) { return (p == 0).all(); })) return;
    const int* const rows = symbolic->rows_below(s);
    const auto below = columns_below<columns>(s, j);
    std::array<Pack, columns> factor;
    std::copy_n(y + j, columns, factor.begin());
    for (std::ptrdiff_t i = 0; i < symbolic->rows_end(s) - rows; ++i) {
      y[rows[i]] +=
          sum_in_pairs<columns>([&](std::size_t m) { return Pack(below[m][i] * factor[m]); });
    }
  }
  template <int columns, class Pack>
  void add_from_below(int s, int j, Pack* y) const {
    const int* const rows = symbolic->rows_below(s);
    const auto below = columns_below<columns>(s, j);
    std::array<Pack, columns> sum;
    std::copy_n(y + j, columns, sum.begin());
    for (std::ptrdiff_t i = 0; i < symbolic->rows_end(s) - rows; ++i) {
      const Pack at = y[rows[i]];
      for (std::size_t m = 0; m < columns; ++m) sum[m] += below[m][i] * at;
    }
    std::copy_n(sum.begin(), columns, y + j);
  }
  template <int columns>
  std::array<const double*, columns> columns_below(int s, int j) const {
    std::array<const double*, columns> result;
    for (int m = 0; m < columns; ++m)
      result[row_number(m)] = column(j + m + 1) - (symbolic->rows_end(s) - symbolic->rows_below(s));
    return result;
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_FACTOR_H
