// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_LAPLACIAN_ELIMINATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_LAPLACIAN_ELIMINATION_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/Elimination.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/row_number.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Numbers of one matrix, or of two that are eliminated together: side by side, so that indices are read once and two numbers are computed at a time.
inline double zero_of(double) { return 0; }
inline Eigen::Array2d zero_of(const Eigen::Array2d&) { return Eigen::Array2d::Zero(); }
inline double absolute(double x) { return std::abs(x); }
inline Eigen::Array2d absolute(const Eigen::Array2d& x) { return x.abs(); }
inline double inverse_of(double x) { return 1 / x; }
inline Eigen::Array2d inverse_of(const Eigen::Array2d& x) { return x.inverse(); }
inline bool are_all(bool x) { return x; }
template <class Comparison>
bool are_all(const Eigen::ArrayBase<Comparison>& x) {
  return x.all();
}

// What is left of a Laplacian and a diagonal while places are eliminated in turn: weights between later places, and the sums of their rows.
template <class Number>
class Laplacian_elimination {
public:
  Laplacian_elimination(const Elimination& e, std::vector<Number>& value,
                        std::vector<Number>& pivot)
      : e_(e), value_(value), pivot_(pivot), first_(e.row.size(), -1),
        next_(e.block_begin.size(), -1), left_(e.block_begin.size(), 0),
        sum_(e.row.size(), zero_of(Number())), weight_(e.row.size(), zero_of(Number())) {}

  // \param entry tells the entry of the matrix at one of its places \return whether the pivot is positive, up to rounding
  template <class Entry>
  bool eliminate(int k, const Entry& entry, const Number& diagonal) {
    for (int i = e_.begin[row_number(k)]; i < e_.begin[row_number(k + 1)]; ++i)
      weight_[row_number(e_.neighbour[row_number(i)])] = -entry(e_.entry[row_number(i)]);
    Number sum = diagonal;
    for (int b = first_[row_number(k)]; b >= 0;) { // blocks with an entry in row k
      const int next = next_[row_number(b)], left = left_[row_number(b)];
      sum += add_columns(e_.block_begin[row_number(b)], e_.block_begin[row_number(b + 1)], left);
      list(b, left - 1);
      b = next;
    }
    const int own = e_.block[row_number(k)], count = e_.count(k);
    sum += add_columns(e_.block_begin[row_number(own)], k, count + 1);
    sum_[row_number(k)] = sum;
    const bool is_positive = finish(k, sum);
    if (k + 1 == e_.block_begin[row_number(own + 1)]) list(own, count);
    return is_positive;
  }

private:
  // Puts a block where its next entry is needed: that with so many left, itself included.
  void list(int block, int left) {
    left_[row_number(block)] = left;
    if (left == 0) return;
    const std::size_t k = row_number(*(e_.rows_end(block) - left));
    next_[row_number(block)] = first_[k];
    first_[k] = block;
  }

  // Adds what the elimination of columns of a block, whose last `left` entries are in the same rows, adds to the weights of the first of these rows.
  // \return what it adds to the sum of the row
  Number add_columns(int begin, int end, int left) {
    Number sum = zero_of(Number());
    if (begin == end) return sum;
    const int* const rows = e_.rows_end(e_.block[row_number(begin)]) - left;
    const auto column = [&](int j) {
      return value_.data() + e_.column_begin[row_number(j + 1)] - left;
    };
    const auto factor = [&](int j) -> Number {
      const Number& l = *column(j);
      sum += l * sum_[row_number(j)];
      return l * pivot_[row_number(j)];
    };
    Number* const w = weight_.data();
    int j = begin;
    for (; j + 4 <= end; j += 4) { // at once, as what is added to is scattered
      const Number *const a = column(j), *const b = column(j + 1), *const c = column(j + 2),
                          *const d = column(j + 3);
      const Number fa = factor(j), fb = factor(j + 1), fc = factor(j + 2), fd = factor(j + 3);
      for (int i = 1; i < left; ++i)
        w[rows[i]] += (a[i] * fa + b[i] * fb) + (c[i] * fc + d[i] * fd);
    }
    for (; j < end; ++j) {
      const Number* const a = column(j);
      const Number fa = factor(j);
      for (int i = 1; i < left; ++i) w[rows[i]] += a[i] * fa;
    }
    return sum;
  }

  bool finish(int k, const Number& sum) {
    const int count = e_.count(k);
    const int* const rows = e_.rows(k);
    Number* const value = value_.data() + e_.column_begin[row_number(k)];
    Number pivot = sum, all = absolute(sum);
    for (int i = 0; i < count; ++i) {
      Number& w = weight_[row_number(rows[i])];
      value[i] = w;
      pivot += w;
      all += absolute(w);
      w = zero_of(w);
    }
    pivot_[row_number(k)] = pivot;
    const Number inverse = inverse_of(pivot);
    for (int i = 0; i < count; ++i) value[i] *= inverse;
    return are_all(pivot > 64 * std::numeric_limits<double>::epsilon() * all);
  }

  const Elimination& e_;
  std::vector<Number>& value_;
  std::vector<Number>& pivot_;
  std::vector<int> first_, next_; // blocks by the row of the entry that is needed next
  std::vector<int> left_;         // number of entries of a block from there on
  std::vector<Number> sum_;       // of each row, when it is eliminated
  std::vector<Number> weight_;    // from the place that is eliminated, by place
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_LAPLACIAN_ELIMINATION_H
