// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_SOLVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_SOLVER_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Elimination.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Laplacian_factor.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Number_pack.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/row_number.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Solves with the factor of a Laplacian.
class Laplacian_solver {
public:
  explicit Laplacian_solver(const Laplacian_factor& factor)
      : e_(*factor.elimination), value_(factor.value.get()), pivot_(factor.pivot.data()) {}

  // Solves for the right sides in columns of b from c on, as many as `Number` holds, and writes columns of x.
  template <class Number>
  void solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::MatrixXd& x, Eigen::Index c) const {
    const int blocks = static_cast<int>(e_.block_begin.size()) - 1;
    std::vector<Number> y(e_.row.size());
    for (std::size_t k = 0; k < y.size(); ++k) y[k] = pack_of<Number>(b, e_.row[k], c);
    for (int block = 0; block < blocks; ++block) forward(block, y.data());
    for (int block = blocks - 1; block >= 0; --block) backward(block, y.data());
    for (std::size_t k = 0; k < y.size(); ++k) unpack(y[k], x, e_.row[k], c);
  }

private:
  // Below a block, its columns have entries in the same rows: four at once, as what is read or added to there is scattered.
  template <class Number>
  void forward(int block, Number* y) const {
    const int begin = e_.block_begin[row_number(block)],
              end = e_.block_begin[row_number(block + 1)], below = e_.count(end - 1);
    for (int j = begin; j < end; ++j)
      for (int i = j + 1; i < end; ++i) y[i] += column(j)[i - j - 1] * y[j];
    const int* const rows = e_.rows_end(block) - below;
    int j = begin;
    for (; j + 4 <= end; j += 4) {
      const double *const p = tail(j, below), *const q = tail(j + 1, below),
                          *const r = tail(j + 2, below), *const s = tail(j + 3, below);
      const Number a = y[j], b = y[j + 1], c = y[j + 2], d = y[j + 3];
      if (is_zero(a) && is_zero(b) && is_zero(c) && is_zero(d)) continue;
      for (int i = 0; i < below; ++i) y[rows[i]] += (p[i] * a + q[i] * b) + (r[i] * c + s[i] * d);
    }
    for (; j < end; ++j) {
      const double* const p = tail(j, below);
      const Number a = y[j];
      if (is_zero(a)) continue;
      for (int i = 0; i < below; ++i) y[rows[i]] += p[i] * a;
    }
  }

  template <class Number>
  void backward(int block, Number* y) const {
    const int begin = e_.block_begin[row_number(block)],
              end = e_.block_begin[row_number(block + 1)], below = e_.count(end - 1);
    for (int j = begin; j < end; ++j) y[j] /= pivot_[j];
    const int* const rows = e_.rows_end(block) - below;
    int j = begin;
    for (; j + 4 <= end; j += 4) {
      const double *const p = tail(j, below), *const q = tail(j + 1, below),
                          *const r = tail(j + 2, below), *const s = tail(j + 3, below);
      Number a = y[j], b = y[j + 1], c = y[j + 2], d = y[j + 3];
      for (int i = 0; i < below; ++i) {
        const Number at = y[rows[i]];
        a += p[i] * at;
        b += q[i] * at;
        c += r[i] * at;
        d += s[i] * at;
      }
      y[j] = a, y[j + 1] = b, y[j + 2] = c, y[j + 3] = d;
    }
    for (; j < end; ++j) {
      const double* const p = tail(j, below);
      Number a = y[j];
      for (int i = 0; i < below; ++i) a += p[i] * y[rows[i]];
      y[j] = a;
    }
    for (int k = end - 2; k >= begin; --k)
      for (int i = k + 1; i < end; ++i) y[k] += column(k)[i - k - 1] * y[i];
  }

  const double* column(int k) const { return value_ + e_.column_begin[row_number(k)]; }
  // its last entries
  const double* tail(int k, int count) const { return column(k + 1) - count; }

  const Elimination& e_;
  const double *value_, *pivot_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_SOLVER_H
