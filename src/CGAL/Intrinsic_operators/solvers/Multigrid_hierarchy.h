// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_HIERARCHY_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_HIERARCHY_H

#include <CGAL/Intrinsic_operators/solvers/Aggregates.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Matrices of fewer and fewer unknowns, each from aggregates of the one before, and the cycle that
solves approximately with all of them: a preconditioner that is Hermitian and positive definite
(Vanek, Mandel and Brezina 1996). Matrices are Hermitian, so that columns have the entries of rows.
*/
template <class Number>
class Multigrid_hierarchy {
public:
  using Matrix = Eigen::SparseMatrix<Number>;
  using Vector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

  // \param a compressed, both triangles \param is_semidefinite whether constants may be in its
  // kernel \throws Indefinite_matrix if the coarsest matrix is not definite
  Multigrid_hierarchy(const Matrix& a, bool is_semidefinite) : finest_(&a) {
    while (matrix(levels_.size()).cols() > coarsest) {
      Level level(matrix(levels_.size()));
      // where aggregation ends, as without connections, smoothing and the factor do the rest
      if (level.prolongation.cols() * 4 > level.prolongation.rows() * 3) break;
      levels_.push_back(std::move(level));
    }
    Matrix last = matrix(levels_.size());
    if (is_semidefinite) // far above rounding, far below all other eigenvalues
      for (int i = 0; i < last.cols(); ++i) {
        const double diagonal = std::real(last.coeff(i, i));
        last.coeffRef(i, i) = diagonal > 0 ? diagonal * (1 + 0x1p-36) : 1;
      }
    coarse_.emplace(raised_factorization(last));
  }

  // the matrix that the cycle solves with approximately
  const Matrix& matrix(std::size_t level) const {
    return level == 0 ? *finest_ : levels_[level - 1].coarse;
  }

  // One cycle from zero.
  Vector operator()(const Vector& b) const { return cycle(b, 0); }

private:
  static constexpr int coarsest = 1000;

  struct Level {
    explicit Level(const Matrix& a)
        : prolongation(smoothed_prolongation(a)), restriction(prolongation.adjoint()),
          coarse(restriction * Matrix(a * prolongation)),
          inverse(a.diagonal().real().unaryExpr([](double d) { return d > 0 ? 1 / d : 0; })) {
      coarse.makeCompressed();
    }

    Matrix prolongation, restriction, coarse;
    Eigen::VectorXd inverse; // of the diagonal
  };

  Vector cycle(const Vector& b, std::size_t l) const {
    if (l == levels_.size()) return coarse_->solve(b);
    const Level& level = levels_[l];
    const Matrix& a = matrix(l);
    Vector x = Vector::Zero(b.size());
    constexpr int sweeps = 2; // backward as often as forward: so the cycle is Hermitian
    const auto rows = static_cast<int>(a.cols());
    for (int s = 0; s < sweeps; ++s)
      for (int i = 0; i < rows; ++i) relax(a, level, b, i, x);
    x += level.prolongation * cycle(level.restriction * (b - a * x), l + 1);
    for (int s = 0; s < sweeps; ++s)
      for (int i = rows - 1; i >= 0; --i) relax(a, level, b, i, x);
    return x;
  }

  // A step of the method of Gauss and Seidel.
  static void relax(const Matrix& a, const Level& level, const Vector& b, int i, Vector& x) {
    Number rest = b[i];
    for (int e = a.outerIndexPtr()[i]; e < a.outerIndexPtr()[i + 1]; ++e)
      rest -= Eigen::numext::conj(a.valuePtr()[e]) * x[a.innerIndexPtr()[e]];
    x[i] += level.inverse[i] * rest;
  }

  const Matrix* finest_;
  std::vector<Level> levels_;
  std::optional<Cholesky_factorization<Number>> coarse_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_HIERARCHY_H
