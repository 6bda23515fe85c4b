// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_EDITING_BIHARMONIC_INTERPOLATION_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_EDITING_BIHARMONIC_INTERPOLATION_IMPL_H

#include <CGAL/Intrinsic_triangulations/applications/editing/Biharmonic_interpolation.h>
#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/row_number.h>

#include <limits>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::vector<std::uint32_t> rows_beside_free_ones(const Eigen::SparseMatrix<double>& a,
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

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Biharmonic_interpolation::Biharmonic_interpolation(const Eigen::SparseMatrix<double>& laplacian,
                                                   Eigen::VectorXd mass,
                                                   std::span<const std::uint32_t> rows,
                                                   std::vector<std::uint32_t> beside)
    : mass_(std::move(mass)), beside_(std::move(beside)),
      is_fixed_(row_number(laplacian.rows()), 0), laplacian_(laplacian),
      harmonic_(laplacian, rows) {
  for (const std::uint32_t r : rows) is_fixed_[r] = 1;
  find_measures(rows);
  factor_strengths();
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Biharmonic_interpolation::find_measures(std::span<const std::uint32_t> rows) {
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
CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Biharmonic_interpolation::factor_strengths() {
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
      "rounding leaves nothing of its distance from another handle; give one of "
      "them");
}

// L d in the rows beside free ones, of the harmonic function d: by differences to each.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigen::MatrixXd
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

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigen::MatrixXd
Biharmonic_interpolation::solve(const Eigen::MatrixXd& values) const {
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(laplacian_.rows(), values.cols());
  const Eigen::MatrixXd harmonic = harmonic_.solve(zero, values);
  if (beside_.empty()) return harmonic;
  const Eigen::MatrixXd right = unit_.asDiagonal() * laplacian_beside(harmonic);
  const Eigen::MatrixXd w = unit_.asDiagonal() * Eigen::MatrixXd(strengths_.solve(right));
  return harmonic_.solve(mass_.asDiagonal() * Eigen::MatrixXd(measures_ * w), values);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_EDITING_BIHARMONIC_INTERPOLATION_IMPL_H
