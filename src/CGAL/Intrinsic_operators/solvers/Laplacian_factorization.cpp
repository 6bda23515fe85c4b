// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Multifrontal_elimination.h>
#include <CGAL/Intrinsic_operators/solvers/Symbolic_factorization.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

static void expect_laplacian(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& d) {
  if (a.rows() != a.cols() || d.size() != a.rows())
    throw std::invalid_argument("a matrix with " + std::to_string(a.rows()) + " rows, " +
                                std::to_string(a.cols()) + " columns and " +
                                std::to_string(d.size()) + " diagonal entries cannot be factored");
  if (!d.allFinite()) throw std::invalid_argument("the diagonal must be finite");
  if (!a.isCompressed()) throw std::invalid_argument("the matrix must be compressed");
  if (!Eigen::Map<const Eigen::VectorXd>(a.valuePtr(), a.nonZeros()).allFinite())
    throw std::invalid_argument("the matrix must be finite");
}

// Eliminates multiples of a Laplacian with diagonals. \return a factor per matrix \throws
// Indefinite_matrix
template <int matrices>
auto eliminate(const Eigen::SparseMatrix<double>& laplacian,
               const Eigen::Array<double, matrices, 1>& unit,
               const Eigen::Array<double, matrices, -1>& diagonal) {
  using Symbolic = Symbolic_factorization;
  const auto symbolic = std::make_shared<const Symbolic>(laplacian);
  typename Multifrontal_elimination<matrices>::Factors factors;
  for (auto& f : factors) f = std::make_shared<Laplacian_factor>(symbolic);
  Multifrontal_elimination<matrices> elimination(factors, laplacian, unit, diagonal);
  const bool has_thread = symbolic->has_halves && std::thread::hardware_concurrency() > 1;
  auto second =
      std::async(has_thread ? std::launch::async | std::launch::deferred : std::launch::deferred,
                 [&] { return elimination.eliminate(Symbolic::second_half); });
  const int of_first = elimination.eliminate(Symbolic::first_half), of_second = second.get();
  for (const int row : {of_first, of_second})
    if (row >= 0) throw Indefinite_matrix(row);
  if (const int row = elimination.eliminate(Symbolic::after_both); row >= 0)
    throw Indefinite_matrix(row);
  return factors;
}

} // namespace internal

Laplacian_factorization::Laplacian_factorization(const Matrix& laplacian,
                                                 const Eigen::VectorXd& diagonal) {
  internal::expect_laplacian(laplacian, diagonal);
  factor_ = internal::eliminate<1>(laplacian, Eigen::Array<double, 1, 1>(1.),
                                   diagonal.transpose().array())[0];
}

std::pair<Laplacian_factorization, Laplacian_factorization>
Laplacian_factorization::of_both(const Matrix& laplacian, const Eigen::VectorXd& diagonal,
                                 double multiple, const Eigen::VectorXd& diagonal_of_multiple) {
  internal::expect_laplacian(laplacian, diagonal);
  internal::expect_laplacian(laplacian, diagonal_of_multiple);
  if (!std::isfinite(multiple)) throw std::invalid_argument("the multiple must be finite");
  Eigen::Array<double, 2, -1> diagonals(2, diagonal.size());
  diagonals << diagonal.transpose().array(), diagonal_of_multiple.transpose().array();
  const auto factors = internal::eliminate<2>(laplacian, {1, multiple}, diagonals);
  return {Laplacian_factorization(factors[0]), Laplacian_factorization(factors[1])};
}

Eigen::Index Laplacian_factorization::size() const {
  return static_cast<Eigen::Index>(factor_->pivot.size());
}

Eigen::MatrixXd Laplacian_factorization::solved(const Eigen::Ref<const Eigen::MatrixXd>& b) const {
  if (b.rows() != size())
    throw std::invalid_argument("the right side must have a row per row of the matrix, " +
                                std::to_string(size()) + ", not " + std::to_string(b.rows()));
  Eigen::MatrixXd x(b.rows(), b.cols());
  Eigen::Index c = 0;
  for (; c + 4 <= b.cols(); c += 4) factor_->solve<4>(b, x, c);
  for (; c + 2 <= b.cols(); c += 2) factor_->solve<2>(b, x, c);
  if (c < b.cols()) factor_->solve<1>(b, x, c);
  return x;
}

} // namespace CGAL::Intrinsic_triangulations
