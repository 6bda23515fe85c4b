// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Multifrontal_elimination.h>
#include <CGAL/Intrinsic_operators/solvers/Multifrontal_factor.h>
#include <CGAL/Intrinsic_operators/solvers/Symbolic_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/minimum_degree_order.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <class Scalar>
void expect_factorable(const Eigen::SparseMatrix<Scalar>& a) {
  if (a.rows() != a.cols())
    throw std::invalid_argument("a matrix with " + std::to_string(a.rows()) + " rows and " +
                                std::to_string(a.cols()) + " columns cannot be factored");
  for (int c = 0; c < a.outerSize(); ++c)
    for (typename Eigen::SparseMatrix<Scalar>::InnerIterator i(a, c); i; ++i)
      if (!std::isfinite(std::real(i.value())) || !std::isfinite(std::imag(i.value())))
        throw std::invalid_argument("the matrix must be finite, but entry (" +
                                    std::to_string(i.row()) + ", " + std::to_string(c) +
                                    ") is not");
}

// Smaller pivots are rounding of zero: some roundings for each of the few entries of a row.
static bool is_definite(double pivot, double diagonal) {
  return pivot > 64 * std::numeric_limits<double>::epsilon() * diagonal;
}

static void expect_rows(Eigen::Index size, Eigen::Index rows) {
  if (rows != size)
    throw std::invalid_argument("the right side must have a row per row of the matrix, " +
                                std::to_string(size) + ", not " + std::to_string(rows));
}

// The factor by a solver, which calls `visit(row, pivot)` for each row, in the order of
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

// Reads protected members of Eigen's class.
template <class Matrix>
class Readable_cholesky
    : public Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Minimum_degree_ordering> {
  using Base = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Minimum_degree_ordering>;

public:
  using Scalar = typename Matrix::Scalar;
  using Base::Base;

  template <class Visit>
  void for_each_pivot(const Visit& visit) const {
    const auto pivots = this->vectorD();
    const auto order = this->permutationPinv().indices();
    for (Eigen::Index k = 0; k < pivots.size(); ++k) visit(order[k], std::real(pivots[k]));
  }
};

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
// Reads protected members of Eigen's class for CHOLMOD.
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

// The factor by fronts of a Hermitian matrix.
class Hermitian_cholesky : public Cholesky_factor<std::complex<double>> {
public:
  explicit Hermitian_cholesky(const Shared_analysis& analysis) : factor_(analysis) {}

  // \param a compressed, both triangles of it
  void factor(const Eigen::SparseMatrix<std::complex<double>>& a) {
    Multifrontal_elimination(*factor_.symbolic, Hermitian_arithmetic(factor_, a)).eliminate();
  }

  Vectors solve(const Vectors& b) const override { return factor_.solve(b); }

private:
  Multifrontal_factor<std::complex<double>> factor_;
};

std::shared_ptr<const Cholesky_factor<double>>
make_cholesky_factor(const Eigen::SparseMatrix<double>& a) {
  using Matrix = Eigen::SparseMatrix<double>;
  expect_factorable(a);
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
  constexpr Eigen::Index large = 100000;
  if (a.rows() >= large) return std::make_shared<Cholesky_factor_of<Readable_cholmod<Matrix>>>(a);
#endif
  return std::make_shared<Cholesky_factor_of<Readable_cholesky<Matrix>>>(a);
}

std::shared_ptr<const Cholesky_factor<std::complex<double>>>
make_cholesky_factor(const Eigen::SparseMatrix<std::complex<double>>& a,
                     Shared_analysis& analysis) {
  expect_factorable(a);
  analyze(a, analysis);
  const auto result = std::make_shared<Hermitian_cholesky>(analysis);
  result->factor(a);
  return result;
}

std::shared_ptr<const Cholesky_factor<std::complex<double>>>
make_cholesky_factor(const Eigen::SparseMatrix<std::complex<double>>& a) {
  expect_factorable(a);
  Eigen::SparseMatrix<std::complex<double>> full = a.selfadjointView<Eigen::Lower>();
  full.makeCompressed();
  Shared_analysis none;
  return make_cholesky_factor(full, none);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
