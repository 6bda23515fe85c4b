// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_CHOLESKY_FACTORIZATION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_CHOLESKY_FACTORIZATION_H

#include <CGAL/Intrinsic_triangulations/compilation.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#if CGAL_INTRINSIC_TRIANGULATIONS_DEFINES(SOLVERS)
#include <Eigen/SparseCholesky>
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif
#endif

namespace CGAL::Intrinsic_triangulations {

/*!
\brief asks for a matrix that was factored once, for any number of right sides.

Syntax of \ref ::Factorization, where its meaning is described.
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

// What a library makes of a matrix. A pivot of row i is what is left of the diagonal entry a_ii.
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

} // namespace internal

/*!
\brief factors a positive definite matrix once, for any number of right sides. A model of `Factorization`.

Large matrices (from 100,000 rows, where measurements found it faster) are factored by CHOLMOD, supernode by supernode, if
programs link it; CMake finds it, and `CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD` says so. Others are factored by Eigen
(`SimplicialLDLT`). Either orders rows by approximate minimum degree.

Copies share the factor, which does not change. Solving is not to be done by two threads at a time with CHOLMOD.

\tparam Scalar `double` for symmetric matrices, `std::complex<double>` for Hermitian ones
*/
template <class Scalar>
  requires std::same_as<Scalar, double> || std::same_as<Scalar, std::complex<double>>
class Cholesky_factorization {
public:
  using Matrix = Eigen::SparseMatrix<Scalar>; ///< what is factored
  using Vectors =
      Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>; ///< right sides, a column each

  /*!
  \brief factors a matrix.
  \param a the matrix, of which the lower triangle is read
  \throws std::invalid_argument if it is not square or an entry is not finite
  \throws Indefinite_matrix if it is not positive definite, up to rounding; it names a row
  \complexity for matrices of a surface with n vertices about \f$n^{3/2}\f$, and memory for \f$n \log n\f$ numbers
  */
  explicit Cholesky_factorization(const Matrix& a)
      : size_(a.rows()), factor_(internal::make_cholesky_factor(a)) {}

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
template <class Scalar>
  requires std::same_as<Scalar, double> || std::same_as<Scalar, std::complex<double>>
  Cholesky_factorization(const Eigen::SparseMatrix<Scalar>&)
->Cholesky_factorization<Scalar>;

namespace internal {

// Factors a matrix that would be positive definite, were there no rounding. Where weights are so large that it has lost the masses beside
// them, the diagonal is raised, also in `m`, by a part of it in the order of rounding errors: 2^-40 at most, which needles and caps of 10^-15 need.
template <class Scalar>
Cholesky_factorization<Scalar> raised_factorization(Eigen::SparseMatrix<Scalar>& m) {
  for (const double raise : {0x1p-48, 0x1p-40}) {
    try {
      return Cholesky_factorization<Scalar>(m);
    } catch (const Indefinite_matrix&) {
      for (int i = 0; i < m.cols(); ++i) m.coeffRef(i, i) *= 1 + raise;
    }
  }
  try {
    return Cholesky_factorization<Scalar>(m);
  } catch (const Indefinite_matrix& error) {
    throw Indefinite_matrix(
        error.row(), "weights there differ by more than doubles hold; refine the triangulation, "
                     "or mollify the mesh");
  }
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#if CGAL_INTRINSIC_TRIANGULATIONS_DEFINES(SOLVERS)
namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <class Scalar>
void expect_factorable(const Eigen::SparseMatrix<Scalar>& a) {
  if (a.rows() != a.cols())
    throw std::invalid_argument("a matrix with " + std::to_string(a.rows()) + " rows and " +
                                std::to_string(a.cols()) + " columns cannot be factored");
  for (int c = 0; c < a.outerSize(); ++c)
    for (typename Eigen::SparseMatrix<Scalar>::InnerIterator i(a, c); i; ++i)
      if (!std::isfinite(std::abs(i.value())))
        throw std::invalid_argument("the matrix must be finite, but entry (" +
                                    std::to_string(i.row()) + ", " + std::to_string(c) +
                                    ") is not");
}

// Less is what rounding leaves of a zero: some roundings for each of the few entries of a row.
inline bool is_definite(double pivot, double diagonal) {
  return pivot > 64 * std::numeric_limits<double>::epsilon() * diagonal;
}

inline void expect_rows(Eigen::Index size, Eigen::Index rows) {
  if (rows != size)
    throw std::invalid_argument("the right side must have a row per row of the matrix, " +
                                std::to_string(size) + ", not " + std::to_string(rows));
}

// A factor that a solver makes, which calls `visit(row, pivot)` for each row, in the order of
// elimination.
template <class Solver>
class Cholesky_factor_of : public Cholesky_factor<typename Solver::Scalar> {
  using Scalar = typename Solver::Scalar;

public:
  using Vectors = typename Cholesky_factor<Scalar>::Vectors;

  explicit Cholesky_factor_of(const Eigen::SparseMatrix<Scalar>& a) : solver_(a) {
    const Eigen::Matrix<Scalar, Eigen::Dynamic, 1> diagonal = a.diagonal();
    solver_.for_each_pivot([&](Eigen::Index row, double pivot) {
      if (!is_definite(pivot, std::real(diagonal[row]))) throw Indefinite_matrix(row);
    });
  }

  Vectors solve(const Vectors& b) const override {
    expect_rows(solver_.rows(), b.rows());
    return solver_.solve(b);
  }

private:
  Solver solver_;
};

// Reads what Eigen's class hides.
template <class Matrix>
class Readable_cholesky : public Eigen::SimplicialLDLT<Matrix> {
public:
  using Scalar = typename Matrix::Scalar;
  using Eigen::SimplicialLDLT<Matrix>::SimplicialLDLT;

  template <class Visit>
  void for_each_pivot(const Visit& visit) const {
    const auto pivots = this->vectorD();
    const auto order = this->permutationPinv().indices();
    for (Eigen::Index k = 0; k < pivots.size(); ++k) visit(order[k], std::real(pivots[k]));
  }
};

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
// Reads what Eigen's class for CHOLMOD hides.
template <class Matrix>
class Readable_cholmod : public Eigen::CholmodSupernodalLLT<Matrix> {
  using Base = Eigen::CholmodSupernodalLLT<Matrix>;

public:
  using Scalar = typename Matrix::Scalar;
  explicit Readable_cholmod(const Matrix& a) {
    this->cholmod().print = 0; // the library prints nothing
    this->analyzePattern(a);
    if (this->m_cholmodFactor == nullptr) throw std::bad_alloc(); // too large for it, or for memory
    this->factorize(a);
  }

  template <class Visit>
  void for_each_pivot(const Visit& visit) const {
    const auto& f = *this->m_cholmodFactor;
    if (f.minor < f.n) visit(row_at(f.minor), -HUGE_VAL); // where it stopped
    const auto *super = static_cast<const int*>(f.super), *pi = static_cast<const int*>(f.pi),
               *px = static_cast<const int*>(f.px);
    const auto* x = static_cast<const Scalar*>(f.x);
    for (std::size_t s = 0; s < f.nsuper; ++s)
      for (int j = super[s]; j < super[s + 1]; ++j) {
        const int down = j - super[s], height = pi[s + 1] - pi[s];
        visit(row_at(static_cast<std::size_t>(j)),
              std::norm(x[px[s] + std::ptrdiff_t{down} * (height + 1)]));
      }
  }

private:
  Eigen::Index row_at(std::size_t column) const {
    return static_cast<const int*>(this->m_cholmodFactor->Perm)[column];
  }
};
#endif

template <class Scalar>
std::shared_ptr<const Cholesky_factor<Scalar>>
cholesky_factor_of(const Eigen::SparseMatrix<Scalar>& a) {
  using Matrix = Eigen::SparseMatrix<Scalar>;
  expect_factorable(a);
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
  constexpr Eigen::Index large = 100000;
  if (a.rows() >= large) return std::make_shared<Cholesky_factor_of<Readable_cholmod<Matrix>>>(a);
#endif
  return std::make_shared<Cholesky_factor_of<Readable_cholesky<Matrix>>>(a);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::shared_ptr<const Cholesky_factor<double>>
make_cholesky_factor(const Eigen::SparseMatrix<double>& a) {
  return cholesky_factor_of(a);
}
CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::shared_ptr<const Cholesky_factor<std::complex<double>>>
make_cholesky_factor(const Eigen::SparseMatrix<std::complex<double>>& a) {
  return cholesky_factor_of(a);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
#endif

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_CHOLESKY_FACTORIZATION_H
