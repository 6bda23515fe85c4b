// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIFRONTAL_ELIMINATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIFRONTAL_ELIMINATION_H

#include <CGAL/Intrinsic_operators/solvers/Symbolic_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
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

/*
Eliminates the rows of Laplacians with diagonals, of one matrix or of several with entries in the
same places, by fronts (Duff and Reid 1983): the weights between the columns of a supernode and all
rows where these have entries. The Schur complement of the rows below adds to the front of the
parent. So computations use contiguous memory. By Grassmann, Taksar and Heyman, the diagonal of a
front has the sums of its rows in place of the diagonal of the matrix: a pivot is the sum of a
column, and nothing is subtracted.
*/
template <int matrices>
class Multifrontal_elimination {
public:
  using Pack = Eigen::Array<double, matrices, 1>; // a number of each matrix
  using Factors = std::array<std::shared_ptr<Laplacian_factor>, matrices>;

  // \param unit the factor of the weights of the matrix \param diagonal a pack per row
  Multifrontal_elimination(const Factors& factors, const Eigen::SparseMatrix<double>& laplacian,
                           const Pack& unit, const Eigen::Array<double, matrices, -1>& diagonal)
      : e_(*factors[0]->symbolic), factors_(factors), laplacian_(laplacian), unit_(unit),
        diagonal_(diagonal), waiting_(row_number(e_.supernodes())) {}

  // Eliminates the supernodes of a part; the two halves may run at the same time, before the
  // others.
  // \return the row of a pivot that is not positive, up to rounding, or -1
  int eliminate(Symbolic_factorization::Part part) {
    if (part == Symbolic_factorization::after_both) add_halves();
    std::vector<Pack> inverse;
    for (int s = 0; s < e_.supernodes(); ++s) {
      if (e_.part[row_number(s)] != part) continue;
      Front& front = assemble(s);
      if (const int row = eliminate_columns(s, front, inverse); row >= 0) return row;
      const int parent = e_.parent(s);
      if (parent >= 0 && e_.part[row_number(parent)] != part) continue; // until both are done
      if (parent >= 0) add_schur_complement(s, parent);
      front = Front();
    }
    return -1;
  }

private:
  // By columns, each from its diagonal on: weights, and on the diagonal sums of rows.
  struct Front {
    int height = 0;
    std::vector<Pack> value;

    explicit Front(int rows = 0)
        : height(rows), value(row_number(std::ptrdiff_t{rows} * (rows + 1) / 2), Pack::Zero()) {}
    // the entry of a column in row 0, if it had one
    Pack* column(int c) {
      return value.data() + std::ptrdiff_t{c} * height - std::ptrdiff_t{c} * (c + 1) / 2;
    }
  };

  // the front of a supernode, possibly with Schur complements of its children
  Front& front_of(int s) {
    Front& front = waiting_[row_number(s)];
    if (front.height == 0) front = Front(e_.height(s));
    return front;
  }

  void add_halves() {
    for (int s = 0; s < e_.supernodes(); ++s)
      if (const int parent = e_.parent(s);
          parent >= 0 && e_.part[row_number(s)] != e_.part[row_number(parent)]) {
        add_schur_complement(s, parent);
        waiting_[row_number(s)] = Front();
      }
  }

  Front& assemble(int s) {
    Front& front = front_of(s);
    const int begin = e_.supernode_begin[row_number(s)];
    for (int c = 0; c < e_.columns(s); ++c) {
      const std::size_t k = row_number(begin + c);
      Pack* const column = front.column(c);
      column[c] += diagonal_.col(e_.row[k]);
      for (int i = e_.entry_begin[k]; i < e_.entry_begin[k + 1]; ++i) {
        const auto [place, number] = e_.entry[row_number(i)];
        column[row_in_front(s, place)] -= laplacian_.valuePtr()[number] * unit_;
      }
    }
    return front;
  }

  int row_in_front(int s, int place) const {
    const int begin = e_.supernode_begin[row_number(s)], columns = e_.columns(s);
    if (place < begin + columns) return place - begin;
    const int* const rows = e_.rows_below(s);
    return columns + static_cast<int>(std::lower_bound(rows, e_.rows_end(s), place) - rows);
  }

  void add_schur_complement(int s, int parent) {
    Front &from = waiting_[row_number(s)], &to = front_of(parent);
    std::vector<int> row;
    for (const int* r = e_.rows_below(s); r != e_.rows_end(s); ++r)
      row.push_back(row_in_front(parent, *r));
    const int columns = e_.columns(s);
    for (std::size_t c = 0; c < row.size(); ++c) {
      Pack* const column = to.column(row[c]);
      const Pack* const rest = from.column(columns + static_cast<int>(c)) + columns;
      for (std::size_t i = c; i < row.size(); ++i) column[row[i]] += rest[i];
    }
  }

  // \return the row of a pivot that is not positive, or -1
  int eliminate_columns(int s, Front& front, std::vector<Pack>& inverse) {
    const int columns = e_.columns(s), begin = e_.supernode_begin[row_number(s)];
    inverse.resize(row_number(columns));
    for (int c = 0; c < front.height; ++c) {
      const int before = std::min(c, columns);
      int j = 0;
      for (; j + 4 <= before; j += 4) add_multiples<4>(front, j, c, inverse);
      for (; j + 2 <= before; j += 2) add_multiples<2>(front, j, c, inverse);
      for (; j < before; ++j) add_multiples<1>(front, j, c, inverse);
      if (c < columns && !finish_column(begin + c, front, c, inverse[row_number(c)]))
        return e_.row[row_number(begin + c)];
    }
    return -1;
  }

  // Adds to column c the result of the elimination of columns from j on.
  template <int columns>
  static void add_multiples(Front& front, int j, int c, const std::vector<Pack>& inverse) {
    std::array<const Pack*, columns> from;
    std::array<Pack, columns> factor;
    for (int m = 0; m < columns; ++m) {
      from[row_number(m)] = front.column(j + m);
      factor[row_number(m)] = from[row_number(m)][c] * inverse[row_number(j + m)];
    }
    Pack* const to = front.column(c);
    to[c] += sum_in_pairs<columns>(
        [&](std::size_t m) { return Pack(from[m][j + static_cast<int>(m)] * factor[m]); });
    for (int i = c + 1; i < front.height; ++i)
      to[i] += sum_in_pairs<columns>([&](std::size_t m) { return Pack(from[m][i] * factor[m]); });
  }

  // Writes a column of the factor. \return whether its pivot is positive
  bool finish_column(int k, Front& front, int c, Pack& inverse) {
    const Pack* const column = front.column(c);
    Pack pivot = column[c], all = pivot.abs();
    for (int i = c + 1; i < front.height; ++i) {
      pivot += column[i];
      all += column[i].abs();
    }
    inverse = pivot.inverse();
    for (std::size_t m = 0; m < matrices; ++m) {
      const auto of_pack = static_cast<Eigen::Index>(m);
      factors_[m]->pivot[row_number(k)] = pivot[of_pack];
      double* value = factors_[m]->value.get() + e_.column_begin[row_number(k)];
      for (int i = c + 1; i < front.height; ++i) *value++ = column[i][of_pack] * inverse[of_pack];
    }
    return (pivot > 64 * std::numeric_limits<double>::epsilon() * all).all();
  }

  const Symbolic_factorization& e_;
  const Factors& factors_;
  const Eigen::SparseMatrix<double>& laplacian_;
  Pack unit_;
  const Eigen::Array<double, matrices, -1>& diagonal_;
  std::vector<Front> waiting_; // of supernodes, with Schur complements of children
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIFRONTAL_ELIMINATION_H
