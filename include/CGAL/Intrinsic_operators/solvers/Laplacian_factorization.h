// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_H

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_triangulations/compilation.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#if CGAL_INTRINSIC_TRIANGULATIONS_DEFINES(SOLVERS)
#include <CGAL/Intrinsic_operators/solvers/Multifrontal_elimination.h>
#include <CGAL/Intrinsic_operators/solvers/Symbolic_factorization.h>
#endif

namespace CGAL::Intrinsic_triangulations {

namespace internal {
struct Laplacian_factor;
} // namespace internal

/*!
\brief factors L + D with the Laplacian L of a weighted graph and a diagonal D that is not negative,
  without any subtraction.

Off its diagonal L is minus the weights, and its rows sum to zero; the diagonal is not read, and D
is given apart: rounding does not lose a D of 1e-15 beside weights of 1e15, as it does in their sum.
Where no weight is negative, neither is any number that is met: the factor, and solutions for right
sides that are not negative, have full relative accuracy entry by entry, whatever the condition of
the matrix is (Grassmann, Taksar and Heyman 1985; Alfa, Xue and Ye 2002). The matrix is then
definite if D is not zero in each component, and rounding cannot make it indefinite. Few negative
weights, as at the border, are no harm.

Rows are permuted by approximate minimum degree, and eliminated supernode by supernode. Copies share
the factor. Different threads may solve at once. Large matrices are factored by two threads, where
there are two processors; the result is the same with one.
*/
class Laplacian_factorization {
public:
  using Matrix = Eigen::SparseMatrix<double>; ///< what is factored
  using Vectors = Eigen::MatrixXd;            ///< right sides, a column each

  /*!
  \brief factors a matrix.
  \param laplacian the matrix L, compressed, both triangles of it
  \param diagonal D, a number per row
  \throws std::invalid_argument if L is not square and symmetric in its pattern, sizes do not fit, or an entry is not finite
  \throws Indefinite_matrix if it is not positive definite; it names a row
  \complexity for matrices of a surface with n vertices about \f$n^{3/2}\f$, and memory for \f$n \log n\f$ numbers
  */
  Laplacian_factorization(const Matrix& laplacian, const Eigen::VectorXd& diagonal);

  /*!
  \brief factors `L + D` and `m L + E` at once, which takes far less than twice the time of one.
  \param laplacian the matrix L, compressed, both triangles of it
  \param diagonal D, a number per row
  \param multiple m, as a time step
  \param diagonal_of_multiple E, a number per row
  \return both factorizations
  \throws std::invalid_argument,Indefinite_matrix as the constructor, for either
  */
  static std::pair<Laplacian_factorization, Laplacian_factorization>
  of_both(const Matrix& laplacian, const Eigen::VectorXd& diagonal, double multiple,
          const Eigen::VectorXd& diagonal_of_multiple);

  /// returns the number of rows.
  Eigen::Index size() const;

  /*!
  \brief solves `(L + D) x = b`.
  \param b right sides, a column each
  \return the solutions, a column each
  \throws std::invalid_argument if b does not have a row per row of the matrix
  \complexity linear in the number of entries of the factor, for each column
  */
  template <class Right_sides>
  typename Right_sides::PlainObject solve(const Eigen::MatrixBase<Right_sides>& b) const {
    return solved(b);
  }

private:
  explicit Laplacian_factorization(std::shared_ptr<const internal::Laplacian_factor> factor)
      : factor_(std::move(factor)) {}

  Eigen::MatrixXd solved(const Eigen::Ref<const Eigen::MatrixXd>& b) const;

  std::shared_ptr<const internal::Laplacian_factor> factor_;
};

} // namespace CGAL::Intrinsic_triangulations

#if CGAL_INTRINSIC_TRIANGULATIONS_DEFINES(SOLVERS)
namespace CGAL::Intrinsic_triangulations {

namespace internal {

inline void expect_laplacian(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& d) {
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

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Laplacian_factorization::Laplacian_factorization(const Matrix& laplacian,
                                                 const Eigen::VectorXd& diagonal) {
  internal::expect_laplacian(laplacian, diagonal);
  factor_ = internal::eliminate<1>(laplacian, Eigen::Array<double, 1, 1>(1.),
                                   diagonal.transpose().array())[0];
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::pair<Laplacian_factorization, Laplacian_factorization>
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

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigen::Index Laplacian_factorization::size() const {
  return static_cast<Eigen::Index>(factor_->pivot.size());
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigen::MatrixXd
Laplacian_factorization::solved(const Eigen::Ref<const Eigen::MatrixXd>& b) const {
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
#endif

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_H
