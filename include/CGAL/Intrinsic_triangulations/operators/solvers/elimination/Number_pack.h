// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_NUMBER_PACK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_NUMBER_PACK_H

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// A number, or a few that the same is done with, side by side: indices are read once, and several numbers computed at a time.
template <class Number>
Number zero_pack() {
  if constexpr (std::is_same_v<Number, double>)
    return 0;
  else
    return Number::Zero();
}
template <class Number>
constexpr std::size_t size_of_pack = sizeof(Number) / sizeof(double);
inline double number_of(double x, std::size_t) { return x; }
template <class Numbers>
double number_of(const Eigen::ArrayBase<Numbers>& x, std::size_t i) {
  return x[static_cast<Eigen::Index>(i)];
}
inline double absolute(double x) { return std::abs(x); }
inline Eigen::Array2d absolute(const Eigen::Array2d& x) { return x.abs(); }
inline double inverse_of(double x) { return 1 / x; }
inline Eigen::Array2d inverse_of(const Eigen::Array2d& x) { return x.inverse(); }
inline bool are_all(bool x) { return x; }
template <class Comparison>
bool are_all(const Eigen::ArrayBase<Comparison>& x) {
  return x.all();
}
inline bool is_zero(double x) { return x == 0; }
template <class Numbers>
bool is_zero(const Eigen::ArrayBase<Numbers>& x) {
  return (x == 0).all();
}

// A row of a matrix, from column c on.
template <class Number>
Number pack_of(const Eigen::Ref<const Eigen::MatrixXd>& m, Eigen::Index row, Eigen::Index c) {
  if constexpr (std::is_same_v<Number, double>)
    return m(row, c);
  else
    return m.template block<1, Number::RowsAtCompileTime>(row, c).transpose().array();
}
inline void unpack(double x, Eigen::MatrixXd& m, Eigen::Index row, Eigen::Index c) {
  m(row, c) = x;
}
template <class Numbers>
void unpack(const Eigen::ArrayBase<Numbers>& x, Eigen::MatrixXd& m, Eigen::Index row,
            Eigen::Index c) {
  m.template block<1, Numbers::RowsAtCompileTime>(row, c) = x.matrix().transpose();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_NUMBER_PACK_H
