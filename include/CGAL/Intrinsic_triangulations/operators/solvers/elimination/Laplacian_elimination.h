// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_ELIMINATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_ELIMINATION_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Elimination.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Number_pack.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/row_number.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

inline void prefetch([[maybe_unused]] const void* memory) {
#ifdef __GNUC__
  __builtin_prefetch(memory);
#endif
}

// Eliminates the places of a Laplacian and a diagonal, or of two with entries at the same places, block by block (Duff and Reid 1983). A block is eliminated
// in a *front*: the weights between its columns and all rows where these have entries. What that leaves between the rows below waits for the block of
// the first of them, on a stack, as blocks come right after what they wait for: all that is computed with is side by side.
template <class Number>
class Laplacian_elimination {
public:
  static constexpr std::size_t matrices = size_of_pack<Number>;

  // \param unit what the weights of the matrix are multiplied by \param value where the factor of each matrix goes
  Laplacian_elimination(const Elimination& e, const Eigen::SparseMatrix<double>& laplacian,
                        const Number& unit, const std::array<double*, matrices>& value)
      : e_(e), laplacian_(laplacian), unit_(unit), value_(value), pivot_(e.row.size()),
        begin_(e.part.size()) {}

  // Eliminates the blocks of a part; those of the two halves may be eliminated at a time, before the others.
  // \param diagonal called with a row \return the row of a pivot that is not positive, up to rounding, or -1
  template <class Diagonal>
  int eliminate(Elimination::Part part, const Diagonal& diagonal) {
    Workspace& own = space_[part];
    own.index.resize(e_.row.size());
    reserve(part, own);
    for (const int block : e_.sequence) {
      const int parent = e_.parent(block);
      if (e_.part[row_number(block)] == part) {
        assemble(block, diagonal, own);
        if (const int row = eliminate_front(block, own); row >= 0) return row;
        keep_rest(block, own);
      } else if (part != Elimination::after_both || parent < 0 ||
                 e_.part[row_number(parent)] != part)
        continue;
      if (parent >= 0) own.waiting.push_back(block);
    }
    return -1;
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
  struct Workspace {
    int rows = 0, columns = 0; // of the front
    std::vector<Number>
        front; // by columns, each from its diagonal on: weights, and on the diagonal sums of rows
    std::vector<Number> inverse; // of the pivots
    std::vector<int> index;      // of places in the front
    std::vector<int> waiting;    // blocks, of which what is left waits
    std::vector<Number> stack;   // that

    // the entry of column c in row 0, if it had one
    Number* column(int c) { return front.data() + std::ptrdiff_t{c} * rows - triangle(c); }
  };

  static std::ptrdiff_t triangle(int rows) { return std::ptrdiff_t{rows} * (rows + 1) / 2; }

  // Memory for the greatest front and the highest stack of a part, which would be asked for again and again.
  void reserve(Elimination::Part part, Workspace& own) const {
    std::vector<std::ptrdiff_t> of_children(e_.part.size(),
                                            0); // what is left of those on the same stack
    std::ptrdiff_t height = 0, highest = 0;
    int rows = 0;
    for (const int b : e_.sequence) {
      if (e_.part[row_number(b)] != part) continue;
      const int last = e_.block_begin[row_number(b + 1)] - 1, parent = e_.parent(b);
      const std::ptrdiff_t rest = triangle(e_.count(last));
      height += rest - of_children[row_number(b)];
      highest = std::max(highest, height);
      rows = std::max(rows, e_.count(e_.block_begin[row_number(b)]) + 1);
      if (parent >= 0 && e_.part[row_number(parent)] == part)
        of_children[row_number(parent)] += rest;
    }
    own.front.reserve(row_number(triangle(rows)));
    own.stack.reserve(row_number(highest));
  }

  template <class Diagonal>
  void assemble(int block, const Diagonal& diagonal, Workspace& own) {
    const int begin = e_.block_begin[row_number(block)],
              end = e_.block_begin[row_number(block + 1)], below = e_.count(end - 1);
    own.columns = end - begin;
    own.rows = own.columns + below;
    own.front.assign(row_number(triangle(own.rows)), zero_pack<Number>());
    for (int k = begin; k < end; ++k) own.index[row_number(k)] = k - begin;
    for (int i = 0; i < below; ++i) own.index[row_number(e_.rows(end - 1)[i])] = own.columns + i;
    const double* const entry = laplacian_.valuePtr();
    for (int k = begin; k < end; ++k) {
      Number* const column = own.column(k - begin);
      column[k - begin] = diagonal(e_.row[row_number(k)]);
      for (int i = e_.later_begin[row_number(k)]; i < e_.later_begin[row_number(k + 1)]; ++i) {
        constexpr int ahead = 32; // entries that follow are anywhere in the matrix
        if (row_number(i + ahead) < e_.entry.size())
          prefetch(entry + e_.entry[row_number(i + ahead)]);
        column[own.index[row_number(e_.later[row_number(i)])]] =
            -entry[e_.entry[row_number(i)]] * unit_;
      }
    }
    for (; !own.waiting.empty() && e_.parent(own.waiting.back()) == block; own.waiting.pop_back())
      add_rest(own.waiting.back(), own);
  }

  // Adds what is left of a block to the front.
  void add_rest(int block, Workspace& own) {
    const int last = e_.block_begin[row_number(block + 1)] - 1, size = e_.count(last);
    const int* const rows = e_.rows(last);
    Workspace& of_block = space_[e_.part[row_number(block)]];
    const Number* rest = of_block.stack.data() + begin_[row_number(block)];
    for (int c = 0; c < size; ++c) {
      Number* const column = own.column(own.index[row_number(rows[c])]);
      for (int i = c; i < size; ++i) column[own.index[row_number(rows[i])]] += *rest++;
    }
    if (&of_block == &own) own.stack.resize(begin_[row_number(block)]);
  }

  void keep_rest(int block, Workspace& own) {
    begin_[row_number(block)] = own.stack.size();
    own.stack.insert(own.stack.end(), own.front.end() - triangle(own.rows - own.columns),
                     own.front.end());
  }

  // \return the row of a pivot that is not positive, or -1
  int eliminate_front(int block, Workspace& own) {
    own.inverse.resize(row_number(own.columns));
    for (int c = 0; c < own.rows; ++c) {
      const int before = std::min(c, own.columns);
      int j = 0;
      for (; j + 4 <= before; j += 4) add_multiples<4>(j, c, own);
      for (; j + 2 <= before; j += 2) add_multiples<2>(j, c, own);
      for (; j < before; ++j) add_multiples<1>(j, c, own);
      if (const int k = e_.block_begin[row_number(block)] + c;
          c < own.columns && !finish(k, c, own))
        return e_.row[row_number(k)];
    }
    return -1;
  }

  // Adds what the elimination of columns from j on adds to column c.
  template <std::size_t columns>
  static void add_multiples(int j, int c, Workspace& own) {
    std::array<const Number*, columns> from;
    std::array<Number, columns> factor;
    for (std::size_t m = 0; m < columns; ++m) {
      const int k = j + static_cast<int>(m);
      from[m] = own.column(k);
      factor[m] = from[m][c] * own.inverse[row_number(k)];
    }
    const auto sum = [&](const auto& entry) -> Number {
      if constexpr (columns == 4)
        return (entry(0) * factor[0] + entry(1) * factor[1]) +
               (entry(2) * factor[2] + entry(3) * factor[3]);
      else if constexpr (columns == 2)
        return entry(0) * factor[0] + entry(1) * factor[1];
      else
        return entry(0) * factor[0];
    };
    Number* const to = own.column(c);
    to[c] += sum([&](std::size_t m) -> const Number& { return from[m][j + static_cast<int>(m)]; });
    for (int i = c + 1; i < own.rows; ++i)
      to[i] += sum([&](std::size_t m) -> const Number& { return from[m][i]; });
  }

  // Writes a column of the factor. \return whether its pivot is positive
  bool finish(int k, int c, Workspace& own) {
    const Number* const column = own.column(c);
    Number pivot = column[c], all = absolute(pivot);
    for (int i = c + 1; i < own.rows; ++i) {
      pivot += column[i];
      all += absolute(column[i]);
    }
    pivot_[row_number(k)] = pivot;
    const Number inverse = inverse_of(pivot);
    own.inverse[row_number(c)] = inverse;
    std::ptrdiff_t entry = e_.column_begin[row_number(k)];
    for (int i = c + 1; i < own.rows; ++i, ++entry) {
      const Number scaled = column[i] * inverse;
      for (std::size_t m = 0; m < matrices; ++m) value_[m][entry] = number_of(scaled, m);
    }
    return are_all(pivot > 64 * std::numeric_limits<double>::epsilon() * all);
  }

  const Elimination& e_;
  const Eigen::SparseMatrix<double>& laplacian_;
  Number unit_;
  std::array<double*, matrices> value_;
  std::vector<Number> pivot_;
  std::vector<std::size_t> begin_; // of each block, where what is left of it begins on its stack
  std::array<Workspace, 3> space_; // of each part
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_ELIMINATION_H
