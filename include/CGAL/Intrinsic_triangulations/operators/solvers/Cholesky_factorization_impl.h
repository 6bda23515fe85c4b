// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_CHOLESKY_FACTORIZATION_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_CHOLESKY_FACTORIZATION_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Cholesky_factorization.h>

#include <Eigen/SparseCholesky>
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

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

template <class Scalar>
class Eigen_factor : public Cholesky_factor<Scalar> {
  using Matrix = Eigen::SparseMatrix<Scalar>;

public:
  using Vectors = typename Cholesky_factor<Scalar>::Vectors;

  explicit Eigen_factor(const Matrix& a) : solver_(a) {
    const auto& place = solver_.permutationP().indices();
    const auto pivots = solver_.vectorD();
    std::vector<int> row(static_cast<std::size_t>(a.rows()));
    for (int r = 0; r < a.rows(); ++r) row[static_cast<std::size_t>(place[r])] = r;
    for (int k = 0; k < a.rows(); ++k) { // in the order of elimination, which ends at a zero
      const int r = row[static_cast<std::size_t>(k)];
      if (!is_definite(std::real(pivots[k]), std::real(a.coeff(r, r)))) throw Indefinite_matrix(r);
    }
  }

  Vectors solve(const Vectors& b) const override {
    expect_rows(solver_.rows(), b.rows());
    return solver_.solve(b);
  }

private:
  Eigen::SimplicialLDLT<Matrix> solver_;
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

  // the row at which it stopped, or the size
  Eigen::Index first_indefinite_row() const {
    const auto& f = *this->m_cholmodFactor;
    return f.minor < f.n ? row_at(f.minor) : static_cast<Eigen::Index>(f.n);
  }

  // calls visit(row, pivot) for each row
  template <class Visit>
  void for_each_pivot(const Visit& visit) const {
    const auto& f = *this->m_cholmodFactor;
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

template <class Scalar>
class Cholmod_factor : public Cholesky_factor<Scalar> {
  using Matrix = Eigen::SparseMatrix<Scalar>;

public:
  using Vectors = typename Cholesky_factor<Scalar>::Vectors;

  explicit Cholmod_factor(const Matrix& a) : solver_(a) {
    if (const Eigen::Index r = solver_.first_indefinite_row(); r < a.rows())
      throw Indefinite_matrix(r);
    const auto diagonal = a.diagonal();
    solver_.for_each_pivot([&](Eigen::Index r, double pivot) {
      if (!is_definite(pivot, std::real(Scalar(diagonal.coeff(r))))) throw Indefinite_matrix(r);
    });
  }

  Vectors solve(const Vectors& b) const override {
    expect_rows(solver_.rows(), b.rows());
    return solver_.solve(b);
  }

private:
  Readable_cholmod<Matrix> solver_;
};
#endif

template <class Scalar>
std::shared_ptr<const Cholesky_factor<Scalar>>
cholesky_factor_of(const Eigen::SparseMatrix<Scalar>& a) {
  expect_factorable(a);
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
  constexpr Eigen::Index large = 100000;
  if (a.rows() >= large) return std::make_shared<Cholmod_factor<Scalar>>(a);
#endif
  return std::make_shared<Eigen_factor<Scalar>>(a);
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_CHOLESKY_FACTORIZATION_IMPL_H
