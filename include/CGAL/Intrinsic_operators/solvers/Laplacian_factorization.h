// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_H

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
struct Laplacian_factor;
} // namespace internal

/*!
\brief factors L + D with the Laplacian L of a weighted graph and a diagonal D that is not negative,
  without any subtraction.

Off its diagonal L is minus the weights, and its rows sum to zero, so the diagonal of L is not read.
D is separate: rounding does not lose a D of 1e-15 beside weights of 1e15, as it does in their sum.
If no weight is negative, no intermediate number is: the factor, and solutions for nonnegative right
sides, have full relative accuracy in each entry, for any condition of the matrix (Grassmann, Taksar
and Heyman 1985; Alfa, Xue and Ye 2002). The matrix is then definite if D has a positive entry in
each component, and rounding cannot make it indefinite. A few negative weights, as at the border, do
no harm.

Rows are ordered by approximate minimum degree, or by nested dissection where that leaves less work
on large matrices, and eliminated supernode by supernode. Copies share the factor. Different threads
may solve at once. With two processors, two threads factor large matrices; the result is the same
with one.
*/
class Laplacian_factorization {
public:
  using Matrix = Eigen::SparseMatrix<double>; ///< what is factored
  using Vectors = Eigen::MatrixXd;            ///< right sides, a column each

  /*!
  \brief factors a matrix.
  \param laplacian the matrix L, compressed, both triangles of it
  \param diagonal D, a number per row
  \throws std::invalid_argument if L is not square and symmetric in its pattern, sizes do not fit,
    or an entry is not finite
  \throws Indefinite_matrix if it is not positive definite; it names a row
  \complexity for matrices of a surface with n vertices about \f$n^{3/2}\f$, and memory for \f$n
    \log n\f$ numbers
  */
  Laplacian_factorization(const Matrix& laplacian, const Eigen::VectorXd& diagonal);

  /// \cond
  // Uses the analysis of a matrix with entries in the same places, or sets it if there is none.
  Laplacian_factorization(const Matrix& laplacian, const Eigen::VectorXd& diagonal,
                          internal::Shared_analysis& analysis);
  /// \endcond

  /*!
  \brief factors `L + D` and `m L + E` at once, which takes far less than twice the time of one.
  \param laplacian the matrix L, compressed, both triangles of it
  \param diagonal D, a number per row
  \param multiple m, such as a time step
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

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_LAPLACIAN_FACTORIZATION_H
