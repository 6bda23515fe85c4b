// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Elimination_impl.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Laplacian_elimination.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Laplacian_solver.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/Ordered_laplacian.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/row_number.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/where_to_run.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Ordered_laplacian::Ordered_laplacian(Matrix laplacian)
    : laplacian_(std::make_shared<const Matrix>(std::move(laplacian))) {
  constexpr Eigen::Index worth_a_thread = 2000;
  const auto find = [l = laplacian_] { return std::make_shared<const Elimination>(*l); };
  elimination_ = std::async(where_to_run(laplacian_->rows() >= worth_a_thread), find).share();
}

inline void expect_diagonal(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& d) {
  if (a.rows() != a.cols() || d.size() != a.rows())
    throw std::invalid_argument("a matrix with " + std::to_string(a.rows()) + " rows, " +
                                std::to_string(a.cols()) + " columns and " +
                                std::to_string(d.size()) + " diagonal entries cannot be factored");
  if (!d.allFinite()) throw std::invalid_argument("the diagonal must be finite");
}

inline void expect_laplacian(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& d) {
  expect_diagonal(a, d);
  if (!a.isCompressed()) throw std::invalid_argument("the matrix must be compressed");
  if (!Eigen::Map<const Eigen::VectorXd>(a.valuePtr(), a.nonZeros()).allFinite())
    throw std::invalid_argument("the matrix must be finite");
}

// Throws if the order of one matrix is not one for another.
inline void expect_same_pattern(const Elimination& e, const Eigen::SparseMatrix<double>& a) {
  if (!e.is_of(a)) throw std::invalid_argument("the matrices must have the same pattern");
}

// Eliminates all places of a Laplacian, its weights times a unit, and a diagonal. \return a factor per matrix \throws Indefinite_matrix
template <class Number, class Diagonal>
auto eliminate_all(std::shared_ptr<const Elimination> elimination,
                   const Eigen::SparseMatrix<double>& laplacian, const Number& unit,
                   const Diagonal& diagonal) {
  const Elimination& e = *elimination;
  std::array<std::shared_ptr<Laplacian_factor>, size_of_pack<Number>> factors;
  std::array<double*, size_of_pack<Number>> value;
  for (std::size_t m = 0; m < factors.size(); ++m) {
    factors[m] = std::make_shared<Laplacian_factor>(elimination);
    value[m] = factors[m]->value.get();
  }
  Laplacian_elimination<Number> rest(e, laplacian, unit, value);
  const auto eliminate = [&](Elimination::Part part) { return rest.eliminate(part, diagonal); };
  auto other = std::async(where_to_run(e.has_halves()), eliminate, Elimination::second_half);
  const int first = eliminate(Elimination::first_half), second = other.get(),
            stopped = first >= 0 ? first : second;
  if (const int row = stopped >= 0 ? stopped : eliminate(Elimination::after_both); row >= 0)
    throw Indefinite_matrix(row);
  for (std::size_t m = 0; m < factors.size(); ++m) factors[m]->pivot = rest.pivots(m);
  return factors;
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Laplacian_factorization::Laplacian_factorization(const Matrix& laplacian,
                                                 const Eigen::VectorXd& diagonal) {
  internal::expect_laplacian(laplacian, diagonal);
  factor(laplacian, diagonal, std::make_shared<const internal::Elimination>(laplacian));
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Laplacian_factorization::Laplacian_factorization(const Matrix& laplacian,
                                                 const Eigen::VectorXd& diagonal,
                                                 const Laplacian_factorization& same_pattern) {
  internal::expect_laplacian(laplacian, diagonal);
  internal::expect_same_pattern(*same_pattern.factor_->elimination, laplacian);
  factor(laplacian, diagonal, same_pattern.factor_->elimination);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Laplacian_factorization::factor(const Matrix& laplacian, const Eigen::VectorXd& diagonal,
                                std::shared_ptr<const internal::Elimination> elimination) {
  factor_ = internal::eliminate_all(std::move(elimination), laplacian, 1.0,
                                    [&](int row) { return diagonal[row]; })[0];
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Laplacian_factorization::Laplacian_factorization(const internal::Ordered_laplacian& laplacian,
                                                 const Eigen::VectorXd& diagonal) {
  internal::expect_laplacian(*laplacian, diagonal);
  factor(*laplacian, diagonal, laplacian.elimination());
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::pair<Laplacian_factorization, Laplacian_factorization>
Laplacian_factorization::of_both(const Matrix& laplacian, const Eigen::VectorXd& diagonal,
                                 double multiple, const Eigen::VectorXd& diagonal_of_multiple) {
  internal::expect_laplacian(laplacian, diagonal);
  return of_both(internal::Ordered_laplacian(laplacian), diagonal, multiple, diagonal_of_multiple);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::pair<Laplacian_factorization, Laplacian_factorization>
Laplacian_factorization::of_both(const internal::Ordered_laplacian& laplacian,
                                 const Eigen::VectorXd& diagonal, double multiple,
                                 const Eigen::VectorXd& diagonal_of_multiple) {
  internal::expect_laplacian(*laplacian, diagonal);
  internal::expect_diagonal(*laplacian, diagonal_of_multiple);
  if (!std::isfinite(multiple)) throw std::invalid_argument("the multiple must be finite");
  const auto factors = internal::eliminate_all(
      laplacian.elimination(), *laplacian, Eigen::Array2d(1, multiple),
      [&](int row) { return Eigen::Array2d(diagonal[row], diagonal_of_multiple[row]); });
  return {Laplacian_factorization(factors[0]), Laplacian_factorization(factors[1])};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigen::MatrixXd
Laplacian_factorization::solved(const Eigen::Ref<const Eigen::MatrixXd>& b) const {
  if (b.rows() != size())
    throw std::invalid_argument("the right side must have a row per row of the matrix, " +
                                std::to_string(size()) + ", not " + std::to_string(b.rows()));
  Eigen::MatrixXd x(b.rows(), b.cols());
  const internal::Laplacian_solver solver(*factor_);
  Eigen::Index c = 0;
  for (; c + 4 <= b.cols(); c += 4) solver.solve<Eigen::Array4d>(b, x, c);
  for (; c + 2 <= b.cols(); c += 2) solver.solve<Eigen::Array2d>(b, x, c);
  if (c < b.cols()) solver.solve<double>(b, x, c);
  return x;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_IMPL_H
