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
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

inline void prefetch([[maybe_unused]] const void* memory) {
#ifdef __GNUC__
  __builtin_prefetch(memory);
#endif
}

// Eliminates the places of a Laplacian and a diagonal, or of two with entries at the same places, block by block (Duff and Reid 1983). A block is eliminated
// in a *front*: the weights between its columns and all rows where these have entries. What that leaves between the rows below is added to the front of
// the block of the first of them, its parent, which waits on a stack: all that is computed with is side by side. As the child with most below it comes first,
// no more fronts wait than the logarithm of the number of blocks.
template <class Number>
class Laplacian_elimination {
public:
  static constexpr std::size_t matrices = size_of_pack<Number>;

  // \param unit what the weights of the matrix are multiplied by \param value where the factor of each matrix goes
  Laplacian_elimination(const Elimination& e, const Eigen::SparseMatrix<double>& laplacian,
                        const Number& unit, const std::array<double*, matrices>& value)
      : e_(e), laplacian_(laplacian), unit_(unit), value_(value), pivot_(e.row.size()) {}

  // Eliminates the blocks of a part; those of the two halves may be eliminated at a time, before the others.
  // \param diagonal called with a row \return the row of a pivot that is not positive, up to rounding, or -1
  template <class Diagonal>
  int eliminate(Elimination::Part part, const Diagonal& diagonal) {
    if (std::find(e_.part.begin(), e_.part.end(), part) == e_.part.end()) return -1;
    Workspace& own = space_[part];
    reserve(part, own);
    for (const int block : e_.sequence) {
      if (e_.part[row_number(block)] != part) continue;
      assemble(block, diagonal, own);
      if (const int row = eliminate_front(block, own); row >= 0) return row;
      if (const int parent = e_.parent(block); parent >= 0) add_rest(parent, block, own);
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
    std::vector<Number> inverse;       // of the pivots
    std::vector<Number> stack;         // fronts of blocks that wait
    std::vector<std::ptrdiff_t> begin; // of each block, where its front begins there; -1: nowhere
    std::vector<int> to;               // of rows below, their places in the front of the parent

    Number* column(int c) { return column_of(front.data(), rows, c); }
  };

  static std::ptrdiff_t triangle(int rows) { return std::ptrdiff_t{rows} * (rows + 1) / 2; }
  // in a front, the entry of column c in row 0, if it had one
  static Number* column_of(Number* front, int rows, int c) {
    return front + std::ptrdiff_t{c} * rows - triangle(c);
  }

  int rows_of(int block) const { return e_.count(e_.block_begin[row_number(block)]) + 1; }
  std::ptrdiff_t size_of_front(int block) const { return triangle(rows_of(block)); }

  // Memory for the greatest front and the highest stack of a part, which would be asked for again and again.
  void reserve(Elimination::Part part, Workspace& own) const {
    std::vector<char> waits(e_.part.size(), 0);
    std::ptrdiff_t height = 0, highest = 0, greatest = 0;
    for (const int b : e_.sequence) {
      if (e_.part[row_number(b)] != part) continue;
      greatest = std::max(greatest, size_of_front(b));
      if (waits[row_number(b)] != 0) height -= size_of_front(b);
      const int parent = e_.parent(b);
      if (parent < 0 || std::exchange(waits[row_number(parent)], 1) != 0) continue;
      highest = std::max(highest, height += size_of_front(parent));
    }
    own.front.reserve(row_number(greatest));
    own.stack.reserve(row_number(highest));
    own.begin.assign(e_.part.size(), -1);
  }

  template <class Diagonal>
  void assemble(int block, const Diagonal& diagonal, Workspace& own) {
    const int begin = e_.block_begin[row_number(block)],
              end = e_.block_begin[row_number(block + 1)];
    own.columns = end - begin;
    own.rows = rows_of(block);
    take_front(block, own);
    const double* const entry = laplacian_.valuePtr();
    for (int k = begin; k < end; ++k) {
      Number* const column = own.column(k - begin);
      column[k - begin] += diagonal(e_.row[row_number(k)]);
      for (int i = e_.later_begin[row_number(k)]; i < e_.later_begin[row_number(k + 1)]; ++i) {
        constexpr int ahead = 32; // entries that follow are anywhere in the matrix
        if (row_number(i + ahead) < e_.entry.size())
          prefetch(entry + e_.entry[row_number(i + ahead)]);
        column[place_in_front(block, e_.later[row_number(i)])] +=
            -entry[e_.entry[row_number(i)]] * unit_;
      }
    }
  }

  // What blocks below have added to the front, those of both halves as well.
  void take_front(int block, Workspace& own) {
    const std::ptrdiff_t begin = own.begin[row_number(block)];
    if (begin >= 0) { // on top
      own.front.assign(own.stack.begin() + begin, own.stack.end());
      own.stack.resize(row_number(begin));
    } else {
      own.front.assign(row_number(size_of_front(block)), zero_pack<Number>());
    }
    if (e_.part[row_number(block)] != Elimination::after_both) return;
    for (const Elimination::Part half : {Elimination::first_half, Elimination::second_half}) {
      const Workspace& other = space_[half];
      if (other.begin.empty() || other.begin[row_number(block)] < 0) continue;
      const Number* const from = other.stack.data() + other.begin[row_number(block)];
      for (std::size_t i = 0; i < own.front.size(); ++i) own.front[i] += from[i];
    }
  }

  // the row of a place in the front of a block, which has it
  int place_in_front(int block, int place) const {
    const int begin = e_.block_begin[row_number(block)],
              end = e_.block_begin[row_number(block + 1)];
    if (place < end) return place - begin;
    const int* const rows = e_.rows(end - 1);
    return end - begin + static_cast<int>(std::lower_bound(rows, e_.rows_end(block), place) - rows);
  }

  // Adds what is left of a block, which is in the front, to the front of its parent.
  void add_rest(int parent, int block, Workspace& own) {
    std::ptrdiff_t& begin = own.begin[row_number(parent)];
    if (begin < 0) {
      begin = static_cast<std::ptrdiff_t>(own.stack.size());
      own.stack.resize(own.stack.size() + row_number(size_of_front(parent)), zero_pack<Number>());
    }
    const int last = e_.block_begin[row_number(block + 1)] - 1;
    own.to.clear();
    for (const int* r = e_.rows(last); r != e_.rows_end(block); ++r)
      own.to.push_back(place_in_front(parent, *r));
    const int rows_above = rows_of(parent);
    for (int c = own.columns; c < own.rows; ++c) {
      Number* const column =
          column_of(own.stack.data() + begin, rows_above, own.to[row_number(c - own.columns)]);
      const Number* const rest = own.column(c) + own.columns;
      for (int i = c - own.columns; i < own.rows - own.columns; ++i)
        column[own.to[row_number(i)]] += rest[i];
    }
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
  std::array<Workspace, 3> space_; // of each part
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_LAPLACIAN_ELIMINATION_H
