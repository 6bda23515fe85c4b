// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_ELIMINATION_ARITHMETIC_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_ELIMINATION_ARITHMETIC_H

#include <CGAL/Intrinsic_operators/solvers/elimination/Multifrontal_factor.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <complex>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>

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
  // `times()`, for each double of a pack, as a sum of doubles of the weight times those of the
  // multiple
  static constexpr int terms = 1;
  static int of_weight(int part, int) { return part; }
  static double of_multiple(const Multiple& m, int part, int) { return m[part]; }
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
  static constexpr int terms = parts;
  static int of_weight(int part, int term) { return part ^ term; }
  static double of_multiple(const Multiple& m, int part, int term) {
    if constexpr (parts == 1)
      return m;
    else
      return term == 0 ? m.real : m.imaginary[part];
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
    using Entries = Eigen::Array<double, parts, Eigen::Dynamic>;
    Eigen::Map<Entries>(factor_.column(place), parts, below) =
        Eigen::Map<const Entries>(column->data() + parts, parts, below) * inverse;
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_ELIMINATION_ELIMINATION_ARITHMETIC_H
