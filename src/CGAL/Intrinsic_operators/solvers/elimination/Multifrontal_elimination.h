// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_MULTIFRONTAL_ELIMINATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_MULTIFRONTAL_ELIMINATION_H

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/elimination/Dense_product.h>
#include <CGAL/Intrinsic_operators/solvers/elimination/Elimination_arithmetic.h>
#include <CGAL/Intrinsic_operators/solvers/elimination/Multifrontal_factor.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Symbolic_factorization.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <future>
#include <limits>
#include <memory>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Eliminates the rows of matrices by fronts (Duff and Reid 1983): the weights between the columns of a
supernode and all rows where these have entries. The Schur complement of the rows below adds to the
front of the parent. So computations use contiguous memory. Wide supernodes are eliminated by panels
of columns; each panel adds to all columns after it by products of dense matrices.
*/
template <class Arithmetic>
class Multifrontal_elimination {
public:
  using Pack = typename Arithmetic::Pack;

  Multifrontal_elimination(const Symbolic_factorization& symbolic, Arithmetic arithmetic)
      : e_(symbolic), arithmetic_(std::move(arithmetic)), waiting_(row_number(e_.supernodes())) {}

  // Eliminates all rows, in two threads if that is worth it and there are two processors; the
  // result is the same. \throws Indefinite_matrix
  void eliminate() {
    using Symbolic = Symbolic_factorization;
    const bool has_thread = e_.has_halves && std::thread::hardware_concurrency() > 1;
    auto second =
        std::async(has_thread ? std::launch::async | std::launch::deferred : std::launch::deferred,
                   [this] { return eliminate(Symbolic::second_half); });
    const int of_first = eliminate(Symbolic::first_half), of_second = second.get();
    for (const int row : {of_first, of_second})
      if (row >= 0) throw Indefinite_matrix(row);
    if (const int row = eliminate(Symbolic::after_both); row >= 0) throw Indefinite_matrix(row);
  }

private:
  using Inverse = typename Arithmetic::Inverse;

  // Eliminates the supernodes of a part; the two halves may run at the same time, before the
  // others.
  // \return the row of a pivot that is not positive, up to rounding, or -1
  int eliminate(Symbolic_factorization::Part part) {
    if (part == Symbolic_factorization::after_both) add_halves();
    Workspace work;
    for (int s = 0; s < e_.supernodes(); ++s) {
      if (e_.part[row_number(s)] != part) continue;
      Front& front = assemble(s);
      if (const int row = eliminate_columns(s, front, work); row >= 0) return row;
      const int parent = e_.parent(s);
      if (parent >= 0 && e_.part[row_number(parent)] != part) continue; // until both are done
      if (parent >= 0) add_schur_complement(s, parent);
      front = Front();
    }
    return -1;
  }

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

  // kept from front to front
  struct Workspace {
    std::vector<Inverse> inverse;
    Dense_product product;
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
      column[c] += arithmetic_.diagonal(e_.row[k]);
      for (int i = e_.entry_begin[k]; i < e_.entry_begin[k + 1]; ++i) {
        const auto [place, number] = e_.entry[row_number(i)];
        column[row_in_front(s, place)] += arithmetic_.weight(number);
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
  int eliminate_columns(int s, Front& front, Workspace& work) {
    constexpr int panel = 64;
    const int columns = e_.columns(s), begin = e_.supernode_begin[row_number(s)];
    work.inverse.resize(row_number(columns));
    for (int j = 0; j < columns; j += panel) {
      const int end = std::min(j + panel, columns);
      for (int c = j; c < end; ++c) {
        add_columns(front, j, c, c, work.inverse);
        if (const int row = e_.row[row_number(begin + c)];
            !arithmetic_.finish_column(begin + c, row, front.column(c) + c, front.height - c - 1,
                                       work.inverse[row_number(c)]))
          return row;
      }
      add_panel(front, j, end, work);
    }
    return -1;
  }

  // Adds the result of the elimination of a panel to the columns after it.
  void add_panel(Front& front, int j, int end, Workspace& work) {
    constexpr int narrow = 8; // copies for products take longer than they save
    if (end - j < narrow || front.height - end < 2 * narrow) {
      for (int c = end; c < front.height; ++c) add_columns(front, j, end, c, work.inverse);
      return;
    }
    for (int c = end; c < front.height; ++c)
      for (int k = j; k < end; ++k) {
        const Pack *const from = front.column(k), weight = from[c];
        front.column(c)[c] += Arithmetic::on_diagonal(
            from[k], weight, Arithmetic::multiple(weight, work.inverse[row_number(k)]));
      }
    for (int part = 0; part < Pack::RowsAtCompileTime; ++part)
      add_products(front, j, end, part, work);
  }

  // The same for one double of each pack, below the diagonal.
  void add_products(Front& front, int j, int end, int part, Workspace& work) {
    constexpr int terms = Arithmetic::terms;
    const int size = front.height - end;
    work.product.resize(size, terms * (end - j));
    for (int k = j; k < end; ++k)
      for (int i = 0; i < size; ++i) {
        const Pack& weight = front.column(k)[end + i];
        const auto multiple = Arithmetic::multiple(weight, work.inverse[row_number(k)]);
        for (int t = 0; t < terms; ++t) {
          const int depth = terms * (k - j) + t;
          work.product.left(i, depth) = weight[Arithmetic::of_weight(part, t)];
          work.product.right(i, depth) = Arithmetic::of_multiple(multiple, part, t);
        }
      }
    work.product.for_each_tile([&](int i, int c, const Dense_product::Tile& sums) {
      for (int m = 0; m < std::min(Dense_product::columns, size - c); ++m) {
        Pack* const to = front.column(end + c + m) + end;
        const int last = std::min(i + Dense_product::rows, size);
        for (int r = std::max(i, c + m + 1); r < last; ++r) to[r][part] += sums(r - i, m);
      }
    });
  }

  // Adds to column c the result of the elimination of columns from j to before `end`.
  static void add_columns(Front& front, int j, int end, int c,
                          const std::vector<Inverse>& inverse) {
    for (; j + 4 <= end; j += 4) add_multiples<4>(front, j, c, inverse);
    for (; j + 2 <= end; j += 2) add_multiples<2>(front, j, c, inverse);
    for (; j < end; ++j) add_multiples<1>(front, j, c, inverse);
  }

  // Adds to column c the result of the elimination of columns from j on.
  template <int columns>
  static void add_multiples(Front& front, int j, int c, const std::vector<Inverse>& inverse) {
    std::array<const Pack*, columns> from;
    std::array<typename Arithmetic::Multiple, columns> factor;
    for (int m = 0; m < columns; ++m) {
      from[row_number(m)] = front.column(j + m);
      factor[row_number(m)] =
          Arithmetic::multiple(from[row_number(m)][c], inverse[row_number(j + m)]);
    }
    Pack* const to = front.column(c);
    to[c] += sum_in_pairs<columns>([&](std::size_t m) {
      return Arithmetic::on_diagonal(from[m][j + static_cast<int>(m)], from[m][c], factor[m]);
    });
    for (int i = c + 1; i < front.height; ++i)
      to[i] += sum_in_pairs<columns>(
          [&](std::size_t m) { return Pack(Arithmetic::times(from[m][i], factor[m])); });
  }

  const Symbolic_factorization& e_;
  Arithmetic arithmetic_;
  std::vector<Front> waiting_; // of supernodes, with Schur complements of children
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_MULTIFRONTAL_ELIMINATION_H
