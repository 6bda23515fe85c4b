// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_ELIMINATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_ELIMINATION_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Elimination.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Number_pack.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/row_number.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// What is left of a Laplacian and a diagonal, or of two with entries at the same places, while places are eliminated in turn: weights between later places,
// and the sums of their rows.
template <class Number>
class Laplacian_elimination {
public:
  static constexpr std::size_t matrices = size_of_pack<Number>;

  // \param value where the factor of each matrix goes
  Laplacian_elimination(const Elimination& e, const std::array<double*, matrices>& value)
      : e_(e), value_(value), pivot_(e.row.size()), next_(e.block_begin.size(), -1),
        left_(e.block_begin.size(), 0),
        sum_(e.row.size(), zero_pack<Number>()), half_{Half(e.row.size()),
                                                       Half(e.has_halves() ? e.row.size() : 0)} {}

  // \param unit what the weights of the matrix are multiplied by \return whether the pivot is positive, up to rounding
  bool eliminate(int k, const Eigen::SparseMatrix<double>& laplacian, const Number& unit,
                 const Number& diagonal) {
    e_.prefetch_after(laplacian, k, true);
    const Elimination::Part part = e_.part[row_number(k)];
    Half& half = half_[part == Elimination::second_half ? 1 : 0];
    const double* const entry = laplacian.valuePtr();
    e_.for_each_later(laplacian, k,
                      [&](int p, int i) { half.weight[row_number(p)] = -entry[i] * unit; });
    Number sum = diagonal + add_blocks(k, half, half);
    if (part == Elimination::after_both && !half_[1].first.empty())
      sum += add_blocks(k, half_[1], half);
    const int own = e_.block[row_number(k)], count = e_.count(k);
    sum += add_columns(e_.block_begin[row_number(own)], k, count + 1, half);
    sum_[row_number(k)] = sum;
    const bool is_positive = finish(k, sum, half);
    if (k + 1 == e_.block_begin[row_number(own + 1)]) list(own, count, half);
    return is_positive;
  }

  // the pivots of a matrix
  std::vector<double> pivots(std::size_t matrix) const {
    std::vector<double> result;
    result.reserve(pivot_.size());
    for (const Number& p : pivot_) result.push_back(number_of(p, matrix));
    return result;
  }

private:
  // What those that compute at a time do not share.
  struct Half {
    explicit Half(std::size_t size) : first(size, -1), weight(size, zero_pack<Number>()) {}

    std::vector<int> first;     // of a list of blocks, by the row of the entry that is needed next
    std::vector<Number> weight; // from the place that is eliminated, by place
  };

  // Puts a block where its next entry is needed: that with so many left, itself included.
  void list(int block, int left, Half& half) {
    left_[row_number(block)] = left;
    if (left == 0) return;
    const std::size_t k = row_number(*(e_.rows_end(block) - left));
    next_[row_number(block)] = half.first[k];
    half.first[k] = block;
  }

  // Adds what blocks with an entry in row k add to its weights. \return what they add to its sum
  Number add_blocks(int k, const Half& listed, Half& half) {
    Number sum = zero_pack<Number>();
    for (int b = listed.first[row_number(k)]; b >= 0;) {
      const int next = next_[row_number(b)], left = left_[row_number(b)];
      sum +=
          add_columns(e_.block_begin[row_number(b)], e_.block_begin[row_number(b + 1)], left, half);
      list(b, left - 1, half);
      b = next;
    }
    return sum;
  }

  // Adds what the elimination of columns of a block, whose last `left` entries are in the same rows, adds to the weights of the first of these rows.
  // \return what it adds to the sum of the row
  Number add_columns(int begin, int end, int left, Half& half) {
    Number sum = zero_pack<Number>();
    if (begin == end) return sum;
    const int* const rows = e_.rows_end(e_.block[row_number(begin)]) - left;
    const auto factor = [&](int j) -> Number {
      const Number l = value(tail(j, left));
      sum += l * sum_[row_number(j)];
      return l * pivot_[row_number(j)];
    };
    int j = begin;
    for (; j + 4 <= end; j += 4) { // at once, as what is added to is scattered
      const std::array<Number, 4> factors{factor(j), factor(j + 1), factor(j + 2), factor(j + 3)};
      add_multiples<4>(rows, left,
                       {tail(j, left), tail(j + 1, left), tail(j + 2, left), tail(j + 3, left)},
                       factors, half);
    }
    for (; j + 2 <= end; j += 2) {
      const std::array<Number, 2> factors{factor(j), factor(j + 1)};
      add_multiples<2>(rows, left, {tail(j, left), tail(j + 1, left)}, factors, half);
    }
    for (; j < end; ++j) add_multiples<1>(rows, left, {tail(j, left)}, {factor(j)}, half);
    return sum;
  }

  // a sum, and no expression that refers to its terms
  template <class Numbers>
  static Numbers add(const Numbers& a, const Numbers& b) {
    return a + b;
  }

  // Adds multiples of columns, of which the entries begin there, to the weights of all these rows but the first.
  template <std::size_t columns>
  void add_multiples(const int* rows, int left, const std::array<std::ptrdiff_t, columns>& column,
                     const std::array<Number, columns>& factors, Half& half) {
    using Pair = Eigen::Array2d;
    Number* const w = half.weight.data();
    const auto sum = [](const auto& term) {
      if constexpr (columns == 4)
        return add(add(term(0), term(1)), add(term(2), term(3)));
      else if constexpr (columns == 2)
        return add(term(0), term(1));
      else
        return term(0);
    };
    int i = 1;
    for (; i + 2 <= left;
         i += 2) { // of two rows at a time, as entries of a column are side by side
      std::array<Pair, matrices> added;
      for (std::size_t m = 0; m < matrices; ++m)
        added[m] = sum([&](std::size_t c) -> Pair {
          return Eigen::Map<const Pair>(value_[m] + column[c] + i) * number_of(factors[c], m);
        });
      for (const int k : {0, 1})
        if constexpr (matrices == 1)
          w[rows[i + k]] += added[0][k];
        else
          w[rows[i + k]] += Pair(added[0][k], added[1][k]);
    }
    for (; i < left; ++i)
      w[rows[i]] += sum([&](std::size_t c) -> Number { return value(column[c] + i) * factors[c]; });
  }

  // an entry of the factor of each matrix
  Number value(std::ptrdiff_t entry) const {
    if constexpr (matrices == 1)
      return value_[0][entry];
    else
      return Number(value_[0][entry], value_[1][entry]);
  }

  // where a column has the first of its last entries
  std::ptrdiff_t tail(int column, int count) const {
    return e_.column_begin[row_number(column + 1)] - count;
  }

  bool finish(int k, const Number& sum, Half& half) {
    const int count = e_.count(k);
    const int* const rows = e_.rows(k);
    const std::ptrdiff_t begin = tail(k, count);
    Number pivot = sum, all = absolute(sum);
    for (int i = 0; i < count; ++i) {
      const Number& w = half.weight[row_number(rows[i])];
      pivot += w;
      all += absolute(w);
    }
    pivot_[row_number(k)] = pivot;
    const Number inverse = inverse_of(pivot);
    for (int i = 0; i < count; ++i) {
      Number& w = half.weight[row_number(rows[i])];
      const Number scaled = w * inverse;
      for (std::size_t m = 0; m < matrices; ++m) value_[m][begin + i] = number_of(scaled, m);
      w = zero_pack<Number>();
    }
    return are_all(pivot > 64 * std::numeric_limits<double>::epsilon() * all);
  }

  const Elimination& e_;
  std::array<double*, matrices> value_;
  std::vector<Number> pivot_;
  std::vector<int> next_;   // of each block in its list
  std::vector<int> left_;   // number of entries of a block from there on
  std::vector<Number> sum_; // of each row, when it is eliminated
  std::array<Half, 2> half_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_ELIMINATION_H
