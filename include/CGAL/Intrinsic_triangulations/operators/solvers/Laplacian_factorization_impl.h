// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/row_number.h>

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Calls `visit(i, k)` for each entry of the factor in column i and row k, rows ascending: the places from which the elimination tree
// leads from an earlier neighbour of k to k.
template <class Visit>
void for_each_factor_entry(const std::vector<int>& begin, const std::vector<int>& earlier,
                           std::vector<int>& parent, const Visit& visit) {
  const int n = static_cast<int>(begin.size()) - 1;
  std::vector<int> last(row_number(n), -1);
  for (int k = 0; k < n; ++k) {
    last[row_number(k)] = k;
    for (int e = begin[row_number(k)]; e < begin[row_number(k + 1)]; ++e)
      for (int i = earlier[row_number(e)]; last[row_number(i)] != k; i = parent[row_number(i)]) {
        if (parent[row_number(i)] < 0) parent[row_number(i)] = k;
        last[row_number(i)] = k;
        visit(i, k);
      }
  }
}

inline std::vector<int> begins_of(const std::vector<int>& counts) {
  if (std::accumulate(counts.begin(), counts.end(), std::int64_t{0}) >
      std::numeric_limits<int>::max())
    throw std::bad_alloc(); // a factor of more than 26 GB
  std::vector<int> begin(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), begin.begin() + 1);
  return begin;
}

inline bool has_symmetric_pattern(const Eigen::SparseMatrix<double>& a) {
  const Eigen::SparseMatrix<double> b = a.transpose();
  return std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Elimination::Elimination(const Eigen::SparseMatrix<double>& a) : entries_of_matrix(a.nonZeros()) {
  if (!has_symmetric_pattern(a))
    throw std::invalid_argument("the matrix must be symmetric; give both triangles of it");
  const int n = static_cast<int>(a.cols());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  if (n > 0) Eigen::AMDOrdering<int>()(a.selfadjointView<Eigen::Lower>(), order);
  row.assign(order.indices().data(), order.indices().data() + order.indices().size());
  std::vector<int> place(row.size()), later(row.size(), 0), before(row.size(), 0);
  for (int k = 0; k < n; ++k) place[row_number(row[row_number(k)])] = k;
  for (int k = 0; k < n; ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, row[row_number(k)]); i; ++i) {
      const int p = place[row_number(static_cast<int>(i.row()))];
      later[row_number(k)] += p > k ? 1 : 0;
      before[row_number(k)] += p < k ? 1 : 0;
    }
  begin = begins_of(later);
  const std::vector<int> begin_before = begins_of(before);
  neighbour.resize(row_number(begin.back()));
  entry.resize(neighbour.size());
  std::vector<int> earlier(row_number(begin_before.back()));
  for (int k = 0; k < n; ++k) {
    int to_later = begin[row_number(k)], to_before = begin_before[row_number(k)];
    const int c = row[row_number(k)];
    for (int e = a.outerIndexPtr()[c]; e < a.outerIndexPtr()[c + 1]; ++e) {
      const int p = place[row_number(a.innerIndexPtr()[e])];
      if (p < k) earlier[row_number(to_before++)] = p;
      if (p <= k) continue;
      neighbour[row_number(to_later)] = p;
      entry[row_number(to_later++)] = e;
    }
  }
  std::vector<int> parent(row.size(), -1), counts(row.size(), 0);
  for_each_factor_entry(begin_before, earlier, parent,
                        [&](int i, int) { ++counts[row_number(i)]; });
  column_begin = begins_of(counts);
  index.resize(row_number(column_begin.back()));
  for (int k = 0; k < n; ++k) {
    const std::size_t c = row_number(k);
    if (k == 0 || parent[c - 1] != k || counts[c - 1] != counts[c] + 1) block_begin.push_back(k);
    block.push_back(static_cast<int>(block_begin.size()) - 1);
  }
  block_begin.push_back(n);
  std::vector<int> next = column_begin;
  for_each_factor_entry(begin_before, earlier, parent,
                        [&](int i, int k) { index[row_number(next[row_number(i)]++)] = k; });
}

inline void expect_laplacian(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& d) {
  if (a.rows() != a.cols() || d.size() != a.rows())
    throw std::invalid_argument("a matrix with " + std::to_string(a.rows()) + " rows, " +
                                std::to_string(a.cols()) + " columns and " +
                                std::to_string(d.size()) + " diagonal entries cannot be factored");
  if (!a.isCompressed()) throw std::invalid_argument("the matrix must be compressed");
  if (!d.allFinite() || !Eigen::Map<const Eigen::VectorXd>(a.valuePtr(), a.nonZeros()).allFinite())
    throw std::invalid_argument("the matrix must be finite");
}

// What is left of a Laplacian and a diagonal while places are eliminated in turn: weights between later places, and the sums of their rows.
class Laplacian_elimination {
public:
  Laplacian_elimination(const Elimination& e, std::vector<double>& value, Eigen::VectorXd& pivot)
      : e_(e), value_(value), pivot_(pivot), first_(e.row.size(), -1),
        next_(e.block_begin.size(), -1), left_(e.block_begin.size(), 0), sum_(e.row.size(), 0),
        weight_(e.row.size(), 0) {}

  // \return whether the pivot is positive, up to rounding
  bool eliminate(int k, const Eigen::SparseMatrix<double>& a, double diagonal) {
    for (int i = e_.begin[row_number(k)]; i < e_.begin[row_number(k + 1)]; ++i)
      weight_[row_number(e_.neighbour[row_number(i)])] = -a.valuePtr()[e_.entry[row_number(i)]];
    double sum = diagonal;
    for (int b = first_[row_number(k)]; b >= 0;) { // blocks with an entry in row k
      const int next = next_[row_number(b)], left = left_[row_number(b)];
      sum += add_columns(e_.block_begin[row_number(b)], e_.block_begin[row_number(b + 1)], left);
      list(b, left - 1);
      b = next;
    }
    const int own = e_.block[row_number(k)], count = column_end(k) - column_begin(k);
    sum += add_columns(e_.block_begin[row_number(own)], k, count + 1);
    sum_[row_number(k)] = sum;
    const bool is_positive = finish(k, sum);
    if (k + 1 == e_.block_begin[row_number(own + 1)]) list(own, count);
    return is_positive;
  }

private:
  int column_begin(int k) const { return e_.column_begin[row_number(k)]; }
  int column_end(int k) const { return e_.column_begin[row_number(k + 1)]; }

  // Puts a block where its next entry is needed: that with so many left, itself included.
  void list(int block, int left) {
    left_[row_number(block)] = left;
    if (left == 0) return;
    const int last = e_.block_begin[row_number(block + 1)] - 1;
    const std::size_t k = row_number(e_.index[row_number(column_end(last) - left)]);
    next_[row_number(block)] = first_[k];
    first_[k] = block;
  }

  // Adds what the elimination of columns, whose last `left` entries are in the same rows, adds to the weights of the first of these rows.
  // \return what it adds to the sum of the row
  double add_columns(int begin, int end, int left) {
    if (begin == end) return 0;
    const int* const rows = e_.index.data() + column_end(end - 1) - left;
    double sum = 0;
    const auto column = [&](int j) { return value_.data() + column_end(j) - left; };
    const auto factor = [&](int j) {
      const double l = *column(j);
      sum += l * sum_[row_number(j)];
      return l * pivot_[j];
    };
    double* const w = weight_.data();
    int j = begin;
    for (; j + 4 <= end; j += 4) { // at once, as what is added to is scattered
      const double *const a = column(j), *const b = column(j + 1), *const c = column(j + 2),
                          *const d = column(j + 3);
      const double fa = factor(j), fb = factor(j + 1), fc = factor(j + 2), fd = factor(j + 3);
      for (int i = 1; i < left; ++i)
        w[rows[i]] += (a[i] * fa + b[i] * fb) + (c[i] * fc + d[i] * fd);
    }
    for (; j < end; ++j) {
      const double* const a = column(j);
      const double fa = factor(j);
      for (int i = 1; i < left; ++i) w[rows[i]] += a[i] * fa;
    }
    return sum;
  }

  bool finish(int k, double sum) {
    double pivot = sum, absolute = std::abs(sum);
    for (int i = column_begin(k); i < column_end(k); ++i) {
      double& w = weight_[row_number(e_.index[row_number(i)])];
      value_[row_number(i)] = w;
      pivot += w;
      absolute += std::abs(w);
      w = 0;
    }
    pivot_[k] = pivot;
    const double inverse = 1 / pivot;
    for (int i = column_begin(k); i < column_end(k); ++i) value_[row_number(i)] *= inverse;
    return pivot > 64 * std::numeric_limits<double>::epsilon() * absolute;
  }

  const Elimination& e_;
  std::vector<double>& value_;
  Eigen::VectorXd& pivot_;
  std::vector<int> first_, next_; // blocks by the row of the entry that is needed next
  std::vector<int> left_;         // number of entries of a block from there on
  std::vector<double> sum_;       // of each row, when it is eliminated
  std::vector<double> weight_;    // from the place that is eliminated, by place
};

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Laplacian_factorization::Laplacian_factorization(const Matrix& laplacian,
                                                 const Eigen::VectorXd& diagonal) {
  internal::expect_laplacian(laplacian, diagonal);
  factor(laplacian, diagonal, std::make_shared<const internal::Elimination>(laplacian));
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Laplacian_factorization::Laplacian_factorization(const Matrix& laplacian,
                                                 const Eigen::VectorXd& diagonal,
                                                 const Laplacian_factorization& same_pattern) {
  internal::expect_laplacian(laplacian, diagonal);
  factor(laplacian, diagonal, same_pattern.factor_->elimination);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Laplacian_factorization::factor(const Matrix& laplacian, const Eigen::VectorXd& diagonal,
                                std::shared_ptr<const internal::Elimination> elimination) {
  const internal::Elimination& e = *elimination;
  if (static_cast<Eigen::Index>(e.row.size()) != laplacian.cols() ||
      e.entries_of_matrix != laplacian.nonZeros())
    throw std::invalid_argument("the matrices must have the same pattern");
  auto result = std::make_shared<Factor>();
  result->value.resize(e.index.size());
  result->pivot.resize(laplacian.cols());
  internal::Laplacian_elimination rest(e, result->value, result->pivot);
  for (int k = 0; k < laplacian.cols(); ++k) {
    const int row = e.row[internal::row_number(k)];
    if (!rest.eliminate(k, laplacian, diagonal[row])) throw Indefinite_matrix(row);
  }
  result->elimination = std::move(elimination);
  factor_ = std::move(result);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigen::MatrixXd
Laplacian_factorization::solved(const Eigen::MatrixXd& b) const {
  const internal::Elimination& e = *factor_->elimination;
  using internal::row_number;
  const int n = static_cast<int>(e.row.size());
  if (b.rows() != n)
    throw std::invalid_argument("the right side must have a row per row of the matrix, " +
                                std::to_string(n) + ", not " + std::to_string(b.rows()));
  Eigen::MatrixXd x(b.rows(), b.cols());
  std::vector<double> y(row_number(n));
  for (Eigen::Index c = 0; c < b.cols(); ++c) {
    for (int k = 0; k < n; ++k) y[row_number(k)] = b(e.row[row_number(k)], c);
    for (int k = 0; k < n; ++k) {
      if (y[row_number(k)] == 0) continue;
      for (int i = e.column_begin[row_number(k)]; i < e.column_begin[row_number(k + 1)]; ++i)
        y[row_number(e.index[row_number(i)])] += factor_->value[row_number(i)] * y[row_number(k)];
    }
    for (int k = n - 1; k >= 0; --k) {
      double sum = y[row_number(k)] / factor_->pivot[k];
      for (int i = e.column_begin[row_number(k)]; i < e.column_begin[row_number(k + 1)]; ++i)
        sum += factor_->value[row_number(i)] * y[row_number(e.index[row_number(i)])];
      y[row_number(k)] = sum;
    }
    for (int k = 0; k < n; ++k) x(e.row[row_number(k)], c) = y[row_number(k)];
  }
  return x;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_IMPL_H
