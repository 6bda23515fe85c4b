// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/elimination/Multifrontal_elimination.h>
#include <CGAL/Intrinsic_operators/solvers/elimination/Multifrontal_factor.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Symbolic_factorization.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <stdexcept>
#include <string>
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
               const Eigen::Array<double, matrices, -1>& diagonal, Shared_analysis& analysis) {
  analyze(laplacian, analysis);
  typename Laplacian_arithmetic<matrices>::Factors factors;
  for (auto& f : factors) f = std::make_shared<Laplacian_factor>(analysis);
  Multifrontal_elimination(*analysis,
                           Laplacian_arithmetic<matrices>(factors, laplacian, unit, diagonal))
      .eliminate();
  return factors;
}

} // namespace internal

Laplacian_factorization::Laplacian_factorization(const Matrix& laplacian,
                                                 const Eigen::VectorXd& diagonal,
                                                 internal::Shared_analysis& analysis) {
  internal::expect_laplacian(laplacian, diagonal);
  factor_ = internal::eliminate<1>(laplacian, Eigen::Array<double, 1, 1>(1.),
                                   diagonal.transpose().array(), analysis)[0];
}

Laplacian_factorization::Laplacian_factorization(const Matrix& laplacian,
                                                 const Eigen::VectorXd& diagonal) {
  internal::Shared_analysis none;
  *this = Laplacian_factorization(laplacian, diagonal, none);
}

std::pair<Laplacian_factorization, Laplacian_factorization>
Laplacian_factorization::of_both(const Matrix& laplacian, const Eigen::VectorXd& diagonal,
                                 double multiple, const Eigen::VectorXd& diagonal_of_multiple) {
  internal::expect_laplacian(laplacian, diagonal);
  internal::expect_laplacian(laplacian, diagonal_of_multiple);
  if (!std::isfinite(multiple)) throw std::invalid_argument("the multiple must be finite");
  Eigen::Array<double, 2, -1> diagonals(2, diagonal.size());
  diagonals << diagonal.transpose().array(), diagonal_of_multiple.transpose().array();
  internal::Shared_analysis none;
  const auto factors = internal::eliminate<2>(laplacian, {1, multiple}, diagonals, none);
  return {Laplacian_factorization(factors[0]), Laplacian_factorization(factors[1])};
}

Eigen::Index Laplacian_factorization::size() const {
  return static_cast<Eigen::Index>(factor_->pivot.size());
}

Eigen::MatrixXd Laplacian_factorization::solved(const Eigen::Ref<const Eigen::MatrixXd>& b) const {
  return factor_->solve(b);
}

} // namespace CGAL::Intrinsic_triangulations
