// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_EDITING_BIHARMONIC_INTERPOLATION_H
#define CGAL_INTRINSIC_OPERATORS_EDITING_BIHARMONIC_INTERPOLATION_H

#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The fixed rows that a matrix joins with free ones, without repetition.
inline std::vector<std::uint32_t> rows_beside_free_ones(const Eigen::SparseMatrix<double>& a,
                                                        std::span<const std::uint32_t> fixed) {
  std::vector<char> is_fixed(row_number(a.rows()), 0);
  for (const std::uint32_t r : fixed) is_fixed[r] = 1;
  std::vector<std::uint32_t> beside;
  for (std::uint32_t r = 0; r < is_fixed.size(); ++r) {
    if (is_fixed[r] == 0) continue;
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, static_cast<int>(r)); i; ++i)
      if (is_fixed[row_number(i.row())] == 0 && i.value() != 0) {
        beside.push_back(r);
        break;
      }
  }
  return beside;
}

/*!
Functions d with given values in some rows and L M^-1 L d = 0 in the others, F, without that product, of which no double holds the small eigenvalues once
weights span eight orders of magnitude or so.

Let M w = L d. Then w is harmonic in F, and so P w_B: of the values in the fixed rows B beside F, with the harmonic measures P, one in its row of B and zero in the others; and
where w is known so is d, from L d = M w in F. What is left is M w = L d in B,

    (P^T M P) w_B = S d,    S = L_B + L_BF P

a dense system, definite and of one row per row of B. Measures are not negative and nothing is subtracted in its matrix; S is applied to differences of d. So errors are
those of the values, where L has no negative weights.
*/
class Biharmonic_interpolation {
public:
  // \param laplacian its rows sum to zero \param mass the diagonal of M \param rows the fixed rows, some in each component
  // \param beside `rows_beside_free_ones()`; time and memory for that many solutions with L are needed
  // \throws Indefinite_matrix if rounding has left no definite matrix; it names a fixed row
  Biharmonic_interpolation(const Eigen::SparseMatrix<double>& laplacian, Eigen::VectorXd mass,
                           std::span<const std::uint32_t> rows, std::vector<std::uint32_t> beside);

  // \param values as of `Fixed_values_solver::solve()`
  Eigen::MatrixXd solve(const Eigen::MatrixXd& values) const;

private:
  void find_measures(std::span<const std::uint32_t> rows);
  void factor_strengths();
  Eigen::MatrixXd laplacian_beside(const Eigen::MatrixXd& harmonic) const;

  Eigen::VectorXd mass_;
  std::vector<std::uint32_t> beside_;
  std::vector<char> is_fixed_;
  Eigen::SparseMatrix<double> laplacian_;
  Fixed_values_solver harmonic_;
  Eigen::MatrixXd measures_, through_free_; // P and L_BF P
  Eigen::VectorXd unit_;                    // of each row of the dense system
  Eigen::LDLT<Eigen::MatrixXd> strengths_;
};

inline Biharmonic_interpolation::Biharmonic_interpolation(
    const Eigen::SparseMatrix<double>& laplacian, Eigen::VectorXd mass,
    std::span<const std::uint32_t> rows, std::vector<std::uint32_t> beside)
    : mass_(std::move(mass)), beside_(std::move(beside)),
      is_fixed_(row_number(laplacian.rows()), 0), laplacian_(laplacian),
      harmonic_(laplacian, rows) {
  for (const std::uint32_t r : rows) is_fixed_[r] = 1;
  find_measures(rows);
  factor_strengths();
}

inline void Biharmonic_interpolation::find_measures(std::span<const std::uint32_t> rows) {
  const auto count = static_cast<Eigen::Index>(beside_.size());
  std::vector<Eigen::Index> place(is_fixed_.size(), -1);
  for (Eigen::Index b = 0; b < count; ++b) place[beside_[row_number(b)]] = b;
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), count);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (place[rows[i]] >= 0) values(static_cast<Eigen::Index>(i), place[rows[i]]) = 1;
  measures_ = harmonic_.solve(Eigen::MatrixXd::Zero(laplacian_.rows(), count), values);
  through_free_ = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index b = 0; b < count; ++b)
    for (Eigen::SparseMatrix<double>::InnerIterator i(laplacian_,
                                                      static_cast<int>(beside_[row_number(b)]));
         i; ++i)
      if (is_fixed_[row_number(i.row())] == 0)
        through_free_.row(b) += i.value() * measures_.row(i.row());
}

// Rows and columns are scaled to a diagonal of ones.
inline void Biharmonic_interpolation::factor_strengths() {
  if (beside_.empty()) return;
  Eigen::MatrixXd a = measures_.transpose() * mass_.asDiagonal() * measures_;
  unit_ = a.diagonal().cwiseSqrt().cwiseInverse();
  a = unit_.asDiagonal() * a * unit_.asDiagonal();
  strengths_.compute(a);
  Eigen::Index least = 0;
  if (strengths_.vectorD().minCoeff(&least) > 64 * std::numeric_limits<double>::epsilon()) return;
  Eigen::VectorXi order = Eigen::VectorXi::LinSpaced(a.rows(), 0, static_cast<int>(a.rows()) - 1);
  order = strengths_.transpositionsP() * order;
  throw Indefinite_matrix(
      beside_[row_number(order[least])],
      "the handle is too close to another handle for doubles; give one of them");
}

// L d in the rows beside free ones, of the harmonic function d: by differences to each.
inline Eigen::MatrixXd
Biharmonic_interpolation::laplacian_beside(const Eigen::MatrixXd& harmonic) const {
  const auto count = static_cast<Eigen::Index>(beside_.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count, harmonic.cols());
  for (Eigen::Index b = 0; b < count; ++b) {
    const auto row = static_cast<Eigen::Index>(beside_[row_number(b)]);
    for (Eigen::Index k = 0; k < count; ++k)
      result.row(b) +=
          through_free_(b, k) *
          (harmonic.row(static_cast<Eigen::Index>(beside_[row_number(k)])) - harmonic.row(row));
    for (Eigen::SparseMatrix<double>::InnerIterator i(laplacian_, static_cast<int>(row)); i; ++i)
      if (is_fixed_[row_number(i.row())] != 0 && i.row() != row)
        result.row(b) += i.value() * (harmonic.row(i.row()) - harmonic.row(row));
  }
  return result;
}

inline Eigen::MatrixXd Biharmonic_interpolation::solve(const Eigen::MatrixXd& values) const {
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(laplacian_.rows(), values.cols());
  const Eigen::MatrixXd harmonic = harmonic_.solve(zero, values);
  if (beside_.empty()) return harmonic;
  const Eigen::MatrixXd right = unit_.asDiagonal() * laplacian_beside(harmonic);
  const Eigen::MatrixXd w = unit_.asDiagonal() * Eigen::MatrixXd(strengths_.solve(right));
  return harmonic_.solve(mass_.asDiagonal() * Eigen::MatrixXd(measures_ * w), values);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_EDITING_BIHARMONIC_INTERPOLATION_H
