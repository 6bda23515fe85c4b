// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_CHOLESKY_FACTORIZATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_CHOLESKY_FACTORIZATION_H

#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <concepts>
#include <memory>
#include <stdexcept>
#include <string>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief requires a matrix factored once, for any number of right sides.

Syntax of \ref ::Factorization, which describes the meaning.
*/
template <class F>
concept Factorization = std::copyable<F> && requires(const F& f, const typename F::Vectors& b) {
  typename F::Matrix;
  { f.size() } -> std::same_as<Eigen::Index>;
  { f.solve(b) } -> std::convertible_to<typename F::Vectors>;
};

/// A matrix is not positive definite, up to rounding.
class Indefinite_matrix : public std::runtime_error {
public:
  /// constructs an error about row `row`; `remedy` says what to do about it, if that is known.
  explicit Indefinite_matrix(Eigen::Index row, const std::string& remedy = {})
      : std::runtime_error("the matrix is not positive definite up to rounding, at row " +
                           std::to_string(row) + (remedy.empty() ? "" : "; ") + remedy),
        row_(row) {}
  /// returns a row of the matrix that depends on others, up to rounding.
  Eigen::Index row() const { return row_; }

private:
  Eigen::Index row_;
};

namespace internal {

struct Symbolic_factorization;

// \throws std::invalid_argument if a matrix is not square or an entry is not finite
template <class Scalar>
void expect_factorable(const Eigen::SparseMatrix<Scalar>& a);

// What a factorization finds from the places of entries alone, for matrices that have theirs in the
// same places.
using Shared_analysis = std::shared_ptr<const Symbolic_factorization>;

// The factor of a matrix. The pivot of row i is the rest of the diagonal entry a_ii.
template <class Scalar>
class Cholesky_factor {
public:
  using Vectors = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  virtual ~Cholesky_factor() = default;
  virtual Vectors solve(const Vectors& b) const = 0;
};

// Throws as the constructor of `Cholesky_factorization` does.
std::shared_ptr<const Cholesky_factor<double>>
make_cholesky_factor(const Eigen::SparseMatrix<double>& a);
std::shared_ptr<const Cholesky_factor<std::complex<double>>>
make_cholesky_factor(const Eigen::SparseMatrix<std::complex<double>>& a);
std::shared_ptr<const Cholesky_factor<std::complex<double>>>
make_cholesky_factor(const Eigen::SparseMatrix<std::complex<double>>& a, Shared_analysis& analysis);

} // namespace internal

/*!
\brief factors a positive definite matrix once, for any number of right sides. A model of
`Factorization`.

Rows are ordered and eliminated as in `Laplacian_factorization`. In measurements that is faster than
Eigen (`SimplicialLDLT`) and than CHOLMOD.

Copies share the factor, which does not change; several threads may solve at a time.

\tparam Scalar `double` for symmetric matrices, `std::complex<double>` for Hermitian ones
*/
template <internal::Matrix_number Scalar>
class Cholesky_factorization {
public:
  using Matrix = Eigen::SparseMatrix<Scalar>; ///< what is factored
  using Vectors =
      Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>; ///< right sides, a column each

  /*!
  \brief factors a matrix.
  \param a the matrix; only its lower triangle is read
  \throws std::invalid_argument if it is not square or an entry is not finite
  \throws Indefinite_matrix if it is not positive definite, up to rounding; it names a row
  \complexity for matrices of a surface with n vertices about \f$n^{3/2}\f$, and memory for \f$n
    \log n\f$ numbers
  */
  explicit Cholesky_factorization(const Matrix& a)
      : size_(a.rows()), factor_(internal::make_cholesky_factor(a)) {}

  /// \cond
  // Uses the analysis of a matrix with entries in the same places, or sets it if there is none.
  // \param a the matrix, compressed, both triangles of it
  Cholesky_factorization(const Matrix& a, internal::Shared_analysis& analysis) requires
      std::same_as<Scalar, std::complex<double>>
      : size_(a.rows()), factor_(internal::make_cholesky_factor(a, analysis)) {}
  /// \endcond

  /// returns the number of rows.
  Eigen::Index size() const { return size_; }

  /*!
  \brief solves `a x = b`.
  \param b right sides, a column each
  \return the solutions, a column each
  \throws std::invalid_argument if b does not have a row per row of the matrix
  \complexity linear in the number of entries of the factor, for each column
  */
  template <class Right_sides>
    requires std::same_as<typename Right_sides::Scalar, Scalar>
  typename Right_sides::PlainObject solve(const Eigen::MatrixBase<Right_sides>& b) const {
    return factor_->solve(b);
  }

private:
  Eigen::Index size_;
  std::shared_ptr<const internal::Cholesky_factor<Scalar>> factor_;
};

/// constructs from a matrix without naming its numbers.
template <internal::Matrix_number Scalar>
Cholesky_factorization(const Eigen::SparseMatrix<Scalar>&) -> Cholesky_factorization<Scalar>;

namespace internal {

// Factors a matrix that is positive definite up to rounding. If masses are lost beside large
// weights, it raises the diagonal, also in `m`, in the order of rounding errors: by a factor of at
// most 1 + 2^-40, which needles and caps of 10^-15 need.
// \param analysis nothing, or a `Shared_analysis`
template <class Scalar, class... Analysis>
Cholesky_factorization<Scalar> raised_factorization(Eigen::SparseMatrix<Scalar>& m,
                                                    Analysis&... analysis) {
  for (const double raise : {0x1p-48, 0x1p-40}) {
    try {
      return Cholesky_factorization<Scalar>(m, analysis...);
    } catch (const Indefinite_matrix&) {
      for (int i = 0; i < m.cols(); ++i) m.coeffRef(i, i) *= 1 + raise;
    }
  }
  try {
    return Cholesky_factorization<Scalar>(m, analysis...);
  } catch (const Indefinite_matrix& error) {
    throw Indefinite_matrix(
        error.row(), "weights there differ by more than doubles hold; refine the triangulation, "
                     "or mollify the mesh");
  }
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_CHOLESKY_FACTORIZATION_H
