// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIFRONTAL_ELIMINATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIFRONTAL_ELIMINATION_H

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Multifrontal_factor.h>
#include <CGAL/Intrinsic_operators/solvers/Symbolic_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

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
What elimination does with the weights, which are minus the entries, of Laplacians with diagonals:
one matrix or several with entries in the same places. By Grassmann, Taksar and Heyman, the diagonal
of a front has the sums of its rows in place of the diagonal of the matrix: a pivot is the sum of a
column, and nothing is subtracted.
*/
template <int matrices>
class Laplacian_arithmetic {
public:
  using Pack = Eigen::Array<double, matrices, 1>; // a number of each matrix
  using Inverse = Pack;                           // of a pivot
  using Multiple = Pack;
  using Factors = std::array<std::shared_ptr<Laplacian_factor>, matrices>;

  // \param unit the factor of the weights of the matrix \param diagonal a pack per row
  Laplacian_arithmetic(const Factors& factors, const Eigen::SparseMatrix<double>& laplacian,
                       const Pack& unit, const Eigen::Array<double, matrices, -1>& diagonal)
      : factors_(factors), laplacian_(laplacian), unit_(unit), diagonal_(diagonal) {}

  Pack diagonal(int row) const { return diagonal_.col(row); }
  Pack weight(int number) const { return -laplacian_.valuePtr()[number] * unit_; }

  // The multiple of an eliminated column that adds to the column where it has this weight.
  static Multiple multiple(const Pack& weight, const Inverse& inverse) { return weight * inverse; }
  static Pack times(const Pack& weight, const Multiple& m) { return weight * m; }
  // \param diagonal of the eliminated column \param weight in the row of the diagonal
  static Pack on_diagonal(const Pack& diagonal, const Pack&, const Multiple& m) {
    return diagonal * m;
  }

  // Writes a column of the factor. \return whether its pivot is positive up to rounding
  bool finish_column(int place, int, const Pack* column, int below, Inverse& inverse) {
    Pack pivot = column[0], all = pivot.abs();
    for (int i = 1; i <= below; ++i) {
      pivot += column[i];
      all += column[i].abs();
    }
    inverse = pivot.inverse();
    for (std::size_t m = 0; m < matrices; ++m) {
      const auto of_pack = static_cast<Eigen::Index>(m);
      factors_[m]->pivot[row_number(place)] = pivot[of_pack];
      double* value = factors_[m]->column(place);
      for (int i = 1; i <= below; ++i) *value++ = column[i][of_pack] * inverse[of_pack];
    }
    // as for Hermitian matrices
    return (pivot > 64 * std::numeric_limits<double>::epsilon() * all).all();
  }

private:
  const Factors& factors_;
  const Eigen::SparseMatrix<double>& laplacian_;
  Pack unit_;
  const Eigen::Array<double, matrices, -1>& diagonal_;
};

// The same for a symmetric or Hermitian matrix, with its diagonal as it is. Packs are numbers;
// complex ones are pairs of doubles.
template <class Number>
class Self_adjoint_arithmetic {
public:
  static constexpr int parts = sizeof(Number) / sizeof(double);
  using Pack = Eigen::Array<double, parts, 1>;
  using Inverse = double;
  struct Complex_multiple {
    double real;
    Pack imaginary; // minus it, and it
  };
  using Multiple = std::conditional_t<parts == 1, double, Complex_multiple>;
  using Factor = Multifrontal_factor<Number>;

  Self_adjoint_arithmetic(Factor& factor, const Eigen::SparseMatrix<Number>& matrix)
      : factor_(factor), matrix_(matrix), diagonal_(matrix.diagonal().real()) {}

  Pack diagonal(int row) const { return real(diagonal_[row]); }
  Pack weight(int number) const {
    const Number& a = matrix_.valuePtr()[number];
    Pack result = real(-std::real(a));
    if constexpr (parts == 2) result[1] = -std::imag(a);
    return result;
  }

  static Multiple multiple(const Pack& weight, Inverse inverse) { // its conjugate
    if constexpr (parts == 1) {
      return weight[0] * inverse;
    } else {
      const double imaginary = -weight[1] * inverse;
      return {weight[0] * inverse, {-imaginary, imaginary}};
    }
  }
  static Pack times(const Pack& weight, const Multiple& m) {
    if constexpr (parts == 1)
      return weight * m;
    else
      return weight * m.real + Pack(weight[1], weight[0]) * m.imaginary;
  }
  static Pack on_diagonal(const Pack&, const Pack& weight, const Multiple& m) {
    if constexpr (parts == 1)
      return -weight * m;
    else
      return real(-(weight[0] * m.real - weight[1] * m.imaginary[1]));
  }

  bool finish_column(int place, int row, const Pack* column, int below, Inverse& inverse) {
    const double pivot = column[0][0];
    inverse = 1 / pivot;
    factor_.pivot[row_number(place)] = pivot;
    using Column = Eigen::Array<double, parts, Eigen::Dynamic>;
    Eigen::Map<Column>(factor_.column(place), parts, below) =
        Eigen::Map<const Column>(column->data() + parts, parts, below) * inverse;
    // Smaller pivots are rounding of zero: some roundings for each of the few entries of a row.
    return pivot > 64 * std::numeric_limits<double>::epsilon() * diagonal_[row];
  }

private:
  static Pack real(double x) {
    Pack result = Pack::Zero();
    result[0] = x;
    return result;
  }

  Factor& factor_;
  const Eigen::SparseMatrix<Number>& matrix_;
  Eigen::VectorXd diagonal_;
};

/*
Eliminates the rows of matrices by fronts (Duff and Reid 1983): the weights between the columns of a
supernode and all rows where these have entries. The Schur complement of the rows below adds to the
front of the parent. So computations use contiguous memory.
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
    std::vector<Inverse> inverse;
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
  int eliminate_columns(int s, Front& front, std::vector<Inverse>& inverse) {
    const int columns = e_.columns(s), begin = e_.supernode_begin[row_number(s)];
    inverse.resize(row_number(columns));
    for (int c = 0; c < front.height; ++c) {
      const int before = std::min(c, columns);
      int j = 0;
      for (; j + 4 <= before; j += 4) add_multiples<4>(front, j, c, inverse);
      for (; j + 2 <= before; j += 2) add_multiples<2>(front, j, c, inverse);
      for (; j < before; ++j) add_multiples<1>(front, j, c, inverse);
      const int row = c < columns ? e_.row[row_number(begin + c)] : -1;
      if (row >= 0 && !arithmetic_.finish_column(begin + c, row, front.column(c) + c,
                                                 front.height - c - 1, inverse[row_number(c)]))
        return row;
    }
    return -1;
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

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIFRONTAL_ELIMINATION_H
