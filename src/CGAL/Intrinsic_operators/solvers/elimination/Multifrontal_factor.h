// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_MULTIFRONTAL_FACTOR_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_MULTIFRONTAL_FACTOR_H

#include <CGAL/Intrinsic_operators/solvers/elimination/Dense_product.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Symbolic_factorization.h>

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
    std::vector<Pack> front(row_number(symbolic->greatest_height()));
    for (int s = 0; s < symbolic->supernodes(); ++s) solve_forward(s, y.data(), front.data());
    for (int s = symbolic->supernodes() - 1; s >= 0; --s) solve_backward(s, y.data(), front.data());
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

  // The rows of a front have places that are scattered: their values are copied to consecutive
  // ones, where panels of columns of the supernode apply to them.
  static constexpr int panel = Dense_panel::columns;

  template <class Pack>
  void solve_forward(int s, Pack* y, Pack* front) const {
    const int begin = symbolic->supernode_begin[row_number(s)], columns = symbolic->columns(s);
    if (std::all_of(y + begin, y + begin + columns, [](const Pack& p) { return (p == 0).all(); }))
      return;
    const int* const rows = symbolic->rows_below(s);
    const int height = symbolic->height(s);
    if (columns == 1) { // copies take longer than they save
      const Multiplied<parts, Pack> times(y[begin], Multiplied<parts, Pack>::none);
      for (int i = 1; i < height; ++i) y[rows[i - 1]] += times(column(begin) + parts * (i - 1));
      return;
    }
    std::copy_n(y + begin, columns, front);
    for (int i = columns; i < height; ++i) front[i] = y[rows[i - columns]];
    int j = 0;
    for (; j + panel <= columns; j += panel) add_below<panel>(begin, j, height, front);
    for (; j < columns; ++j) add_below<1>(begin, j, height, front);
    std::copy_n(front, columns, y + begin);
    for (int i = columns; i < height; ++i) y[rows[i - columns]] = front[i];
  }

  template <class Pack>
  void solve_backward(int s, Pack* y, Pack* front) const {
    const int begin = symbolic->supernode_begin[row_number(s)], columns = symbolic->columns(s);
    const int* const rows = symbolic->rows_below(s);
    const int height = symbolic->height(s);
    if (columns == 1) {
      Pack sum = y[begin] / pivot[row_number(begin)];
      for (int i = 1; i < height; ++i)
        sum += Multiplied<parts, Pack>(y[rows[i - 1]], Multiplied<parts, Pack>::of_entries)(
            column(begin) + parts * (i - 1));
      y[begin] = sum;
      return;
    }
    for (int j = 0; j < columns; ++j) front[j] = y[begin + j] / pivot[row_number(begin + j)];
    for (int i = columns; i < height; ++i) front[i] = y[rows[i - columns]];
    int j = columns;
    for (; j % panel != 0; --j) add_from_below<1>(begin, j - 1, height, front);
    for (; j > 0; j -= panel) add_from_below<panel>(begin, j - panel, height, front);
    std::copy_n(front, columns, y + begin);
  }

  // Eliminates some columns of a front from column j on.
  template <int columns, class Pack>
  void add_below(int begin, int j, int height, Pack* front) const {
    using Times = Multiplied<parts, Pack>;
    for (int m = 1; m < columns; ++m)
      for (int k = 0; k < m; ++k)
        front[j + m] +=
            Times(front[j + k], Times::none)(column(begin + j + k) + parts * (m - k - 1));
    const auto below = columns_below<columns>(begin + j);
    const auto times = [&]<std::size_t... m>(std::index_sequence<m...>) {
      return std::array<Times, columns>{Times(front[j + static_cast<int>(m)], Times::none)...};
    }
    (std::make_index_sequence<columns>());
    Pack* const rest = front + j + columns;
    const std::ptrdiff_t count = height - j - columns;
    if constexpr (columns == panel && parts == 1 && Pack::SizeAtCompileTime == 1)
      return Dense_panel::add(below, front[j].data(), count, rest->data());
    for (std::ptrdiff_t i = 0; i < count; ++i)
      rest[i] +=
          sum_in_pairs<columns>([&](std::size_t m) { return times[m](below[m] + parts * i); });
  }

  // The sum of each column is that of four sums, which a processor adds at a time.
  template <int columns, class Pack>
  void add_from_below(int begin, int j, int height, Pack* front) const {
    using Times = Multiplied<parts, Pack>;
    constexpr std::size_t lanes = 4;
    const auto below = columns_below<columns>(begin + j);
    const Pack* const rest = front + j + columns;
    const std::ptrdiff_t count = height - j - columns;
    std::array<std::array<Pack, lanes>, columns> sums;
    for (auto& sum : sums) sum.fill(Pack::Zero());
    std::ptrdiff_t i = 0;
    if constexpr (columns == panel && parts == 1 && Pack::SizeAtCompileTime == 1)
      i = Dense_panel::sum(below, rest->data(), count, sums[0][0].data());
    for (; i + static_cast<std::ptrdiff_t>(lanes) <= count; i += lanes)
      for (std::size_t m = 0; m < columns; ++m)
        for (std::size_t l = 0; l < lanes; ++l) {
          const std::ptrdiff_t at = i + static_cast<std::ptrdiff_t>(l);
          sums[m][l] += Times(rest[at], Times::of_entries)(below[m] + parts * at);
        }
    for (std::size_t l = 0; i < count; ++i, ++l)
      for (std::size_t m = 0; m < columns; ++m)
        sums[m][l] += Times(rest[i], Times::of_entries)(below[m] + parts * i);
    for (int m = columns - 1; m >= 0; --m) {
      const auto& sum = sums[row_number(m)];
      front[j + m] += (sum[0] + sum[1]) + (sum[2] + sum[3]);
      for (int k = m + 1; k < columns; ++k)
        front[j + m] +=
            Times(front[j + k], Times::of_entries)(column(begin + j + m) + parts * (k - m - 1));
    }
  }

  // where the entries of some columns from k on begin, in the row after these columns
  template <int columns>
  std::array<const double*, columns> columns_below(int k) const {
    std::array<const double*, columns> result;
    for (int m = 0; m < columns; ++m)
      result[row_number(m)] = column(k + m) + parts * (columns - 1 - m);
    return result;
  }
};

struct Laplacian_factor : Multifrontal_factor<double> {
  using Multifrontal_factor::Multifrontal_factor;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_MULTIFRONTAL_FACTOR_H
