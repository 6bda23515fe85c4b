// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIFRONTAL_FACTOR_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIFRONTAL_FACTOR_H

#include <CGAL/Intrinsic_operators/solvers/Symbolic_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The sum of the terms m to m + n - 1. Calls in the innermost loop would double the time to factor.
template <std::size_t n, class Term>
EIGEN_ALWAYS_INLINE auto sum_in_pairs(const Term& term, std::size_t m = 0) {
  if constexpr (n == 1)
    return term(m);
  else
    return decltype(term(m))(sum_in_pairs<n / 2>(term, m) + sum_in_pairs<n / 2>(term, m + n / 2));
}

// A pack of numbers from several right sides, to be multiplied by entries of a factor. Complex
// numbers are pairs of doubles, in packs and factors.
template <int parts, class Pack>
class Multiplied {
public:
  enum Conjugation { none, of_entries };

  explicit Multiplied(const Pack& z, Conjugation c) : z_(z) {
    if constexpr (parts == 2)
      for (Eigen::Index i = 0; i < z.size(); i += 2) { // times i, or -i
        turned_[i] = c == none ? -z[i + 1] : z[i + 1];
        turned_[i + 1] = c == none ? z[i] : -z[i];
      }
  }

  Pack operator()(const double* entry) const {
    if constexpr (parts == 2)
      return entry[0] * z_ + entry[1] * turned_;
    else
      return entry[0] * z_;
  }

private:
  Pack z_, turned_;
};

// The factor of a Hermitian matrix, or of a Laplacian and a diagonal: unit triangular, minus
// `value` below the diagonal, times the pivots, times its adjoint.
template <class Number>
struct Multifrontal_factor {
  static constexpr int parts = sizeof(Number) / sizeof(double); // doubles of a number
  using Vectors = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;

  // leaves the numbers to be written
  explicit Multifrontal_factor(std::shared_ptr<const Symbolic_factorization> s)
      : symbolic(std::move(s)), value(std::make_unique_for_overwrite<double[]>(
                                    parts * row_number(symbolic->column_begin.back()))),
        pivot(symbolic->row.size()) {}

  Vectors solve(const Eigen::Ref<const Vectors>& b) const {
    if (row_number(b.rows()) != pivot.size())
      throw std::invalid_argument("the right side must have a row per row of the matrix, " +
                                  std::to_string(pivot.size()) + ", not " +
                                  std::to_string(b.rows()));
    Vectors x(b.rows(), b.cols());
    constexpr int widest = 4 / parts; // four doubles fill a vector of AVX
    Eigen::Index c = 0;
    for (; c + widest <= b.cols(); c += widest) solve<widest>(b, x, c);
    if constexpr (widest > 2)
      for (; c + 2 <= b.cols(); c += 2) solve<2>(b, x, c);
    if (c < b.cols()) solve<1>(b, x, c);
    return x;
  }

  double* column(int k) { return value.get() + parts * std::ptrdiff_t{begin(k)}; }
  const double* column(int k) const { return value.get() + parts * std::ptrdiff_t{begin(k)}; }

  std::shared_ptr<const Symbolic_factorization> symbolic;
  std::unique_ptr<double[]> value; // not a vector, which would write megabytes of zeros first
  std::vector<double> pivot;       // by places

private:
  int begin(int k) const { return symbolic->column_begin[row_number(k)]; }

  // Solves for the columns of b from c on, as many as a pack holds, and writes those of x.
  template <int right_sides>
  void solve(const Eigen::Ref<const Vectors>& b, Vectors& x, Eigen::Index c) const {
    using Pack = Eigen::Array<double, parts * right_sides, 1>;
    std::vector<Pack> y(pivot.size());
    for (std::size_t k = 0; k < y.size(); ++k)
      for (int r = 0; r < right_sides; ++r) read(b(symbolic->row[k], c + r), y[k], r);
    for (int s = 0; s < symbolic->supernodes(); ++s) solve_forward(s, y.data());
    for (int s = symbolic->supernodes() - 1; s >= 0; --s) solve_backward(s, y.data());
    for (std::size_t k = 0; k < y.size(); ++k)
      for (int r = 0; r < right_sides; ++r) write(y[k], r, x(symbolic->row[k], c + r));
  }

  template <class Pack>
  static void read(const Number& from, Pack& pack, int r) {
    pack[parts * r] = std::real(from);
    if constexpr (parts == 2) pack[2 * r + 1] = std::imag(from);
  }
  template <class Pack>
  static void write(const Pack& pack, int r, Number& to) {
    if constexpr (parts == 2)
      to = {pack[2 * r], pack[2 * r + 1]};
    else
      to = pack[r];
  }

  template <class Pack>
  void solve_forward(int s, Pack* y) const {
    const int begin = symbolic->supernode_begin[row_number(s)], end = begin + symbolic->columns(s);
    for (int j = begin; j < end; ++j) {
      const Multiplied<parts, Pack> times(y[j], Multiplied<parts, Pack>::none);
      for (int i = j + 1; i < end; ++i) y[i] += times(column(j) + parts * (i - j - 1));
    }
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
      for (int i = k + 1; i < end; ++i)
        y[k] += Multiplied<parts, Pack>(y[i], Multiplied<parts, Pack>::of_entries)(
            column(k) + parts * (i - k - 1));
  }

  // Some columns of a supernode from j on at once: below it they have entries in the same rows,
  // which are scattered.
  template <int columns, class Pack>
  void add_below(int s, int j, Pack* y) const {
    if (std::all_of(y + j, y + j + columns, [](const Pack& p) { return (p == 0).all(); })) return;
    const int* const rows = symbolic->rows_below(s);
    const auto below = columns_below<columns>(s, j);
    const auto times = [&]<std::size_t... m>(std::index_sequence<m...>) {
      using Times = Multiplied<parts, Pack>;
      return std::array<Times, columns>{Times(y[j + static_cast<int>(m)], Times::none)...};
    }
    (std::make_index_sequence<columns>());
    for (std::ptrdiff_t i = 0; i < symbolic->rows_end(s) - rows; ++i)
      y[rows[i]] +=
          sum_in_pairs<columns>([&](std::size_t m) { return times[m](below[m] + parts * i); });
  }
  template <int columns, class Pack>
  void add_from_below(int s, int j, Pack* y) const {
    const int* const rows = symbolic->rows_below(s);
    const auto below = columns_below<columns>(s, j);
    std::array<Pack, columns> sum;
    std::copy_n(y + j, columns, sum.begin());
    for (std::ptrdiff_t i = 0; i < symbolic->rows_end(s) - rows; ++i) {
      const Multiplied<parts, Pack> times(y[rows[i]], Multiplied<parts, Pack>::of_entries);
      for (std::size_t m = 0; m < columns; ++m) sum[m] += times(below[m] + parts * i);
    }
    std::copy_n(sum.begin(), columns, y + j);
  }
  template <int columns>
  std::array<const double*, columns> columns_below(int s, int j) const {
    const std::ptrdiff_t below = symbolic->rows_end(s) - symbolic->rows_below(s);
    std::array<const double*, columns> result;
    for (int m = 0; m < columns; ++m) result[row_number(m)] = column(j + m + 1) - parts * below;
    return result;
  }
};

struct Laplacian_factor : Multifrontal_factor<double> {
  using Multifrontal_factor::Multifrontal_factor;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIFRONTAL_FACTOR_H
