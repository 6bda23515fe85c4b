// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_MULTIGRID_HIERARCHY_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_MULTIGRID_HIERARCHY_H

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_operators/solvers/multigrid/Aggregates.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
A Hermitian matrix, with the sums of its rows if it is real. Products are sums of entries times
differences of values: their rounding is relative to the differences, where constants, which a
Laplacian takes to zero, may be far larger. So sums of rows count that are less than rounding of the
diagonal, as those by small masses are.
*/
template <class Number>
struct Matrix_with_sums {
  using Matrix = Eigen::SparseMatrix<Number>;
  using Vector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

  // entry i of a x
  Number times(const Vector& x, Eigen::Index i) const {
    const int *const begin = matrix.outerIndexPtr() + i, *const row = matrix.innerIndexPtr();
    const Number* const value = matrix.valuePtr();
    if constexpr (std::same_as<Number, double>) {
      double result = excess[i] * x[i];
      for (int e = begin[0]; e < begin[1]; ++e) result += value[e] * (x[row[e]] - x[i]);
      return result;
    } else { // columns have the conjugate entries of rows
      Number result = 0;
      for (int e = begin[0]; e < begin[1]; ++e) result += Eigen::numext::conj(value[e]) * x[row[e]];
      return result;
    }
  }
  Vector operator*(const Vector& x) const {
    return Vector::NullaryExpr(x.size(), [&](Eigen::Index i) { return times(x, i); });
  }

  Matrix matrix;
  Eigen::VectorXd excess; // zero for complex numbers
};

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

  // \param a compressed, both triangles; must outlive this object. Constants may be in its kernel
  // in components where all excess is zero. \throws Indefinite_matrix if the coarsest matrix is not
  // definite
  explicit Multigrid_hierarchy(const Matrix_with_sums<Number>& a) : finest_(&a) {
    while (matrix(levels_.size()).matrix.cols() > coarsest) {
      Level level(matrix(levels_.size()));
      // where aggregation ends, smoothing and the factor do the rest
      if (level.prolongation.cols() * 4 > level.prolongation.rows() * 3) break;
      levels_.push_back(std::move(level));
    }
    factor_last(matrix(levels_.size()));
  }

  // One cycle from zero.
  Vector operator()(const Vector& b) const { return cycle(b, 0); }

private:
  static constexpr int coarsest = 1000;

  struct Level {
    explicit Level(const Matrix_with_sums<Number>& a)
        : prolongation(smoothed_prolongation(a.matrix, a.excess)),
          restriction(prolongation.adjoint()), coarse{Matrix(restriction *
                                                             Matrix(a.matrix * prolongation)),
                                                      restriction.real() * a.excess},
          inverse(
              a.matrix.diagonal().real().unaryExpr([](double d) { return d > 0 ? 1 / d : 0; })) {
      coarse.matrix.makeCompressed();
    }

    Matrix prolongation, restriction;
    Matrix_with_sums<Number> coarse;
    Eigen::VectorXd inverse; // of the diagonal
  };

  // the matrix that the cycle solves with approximately
  const Matrix_with_sums<Number>& matrix(std::size_t level) const {
    return level == 0 ? *finest_ : levels_[level - 1].coarse;
  }

  // Real matrices are factored with the sums of their rows. Where constants are in the kernel,
  // right sides sum to zero, so that one raised entry fixes one value at zero.
  void factor_last(const Matrix_with_sums<Number>& a) {
    Matrix m = a.matrix;
    if constexpr (std::same_as<Number, double>) {
      Eigen::VectorXd excess = a.excess;
      const std::vector<std::uint32_t> component = components_of_matrix(m);
      const std::vector<char> is_singular =
          components_where_all(component, [&](Eigen::Index r) { return a.excess[r] == 0; });
      for (const std::uint32_t r : least_rows(component, is_singular)) {
        const int row = static_cast<int>(r);
        const double diagonal = m.coeff(row, row);
        excess[row] = diagonal > 0 ? diagonal : 1;
        m.coeffRef(row, row) += excess[row];
      }
      m.makeCompressed();
      try {
        coarse_.template emplace<Laplacian_factorization>(m, excess);
        return;
      } catch (const Indefinite_matrix&) { // has many negative weights
      }
    }
    coarse_.template emplace<Cholesky_factorization<Number>>(raised_factorization(m));
  }

  Vector solve_last(const Vector& b) const {
    if constexpr (std::same_as<Number, double>)
      if (const auto* const f = std::get_if<Laplacian_factorization>(&coarse_)) return f->solve(b);
    return std::get<Cholesky_factorization<Number>>(coarse_).solve(b);
  }

  Vector cycle(const Vector& b, std::size_t l) const {
    if (l == levels_.size()) return solve_last(b);
    const Level& level = levels_[l];
    const Matrix_with_sums<Number>& a = matrix(l);
    Vector x = Vector::Zero(b.size());
    constexpr int sweeps = 2; // backward as often as forward: so the cycle is Hermitian
    const Eigen::Index rows = b.size();
    for (int s = 0; s < sweeps; ++s)
      for (Eigen::Index i = 0; i < rows; ++i) relax(a, level, b, i, x);
    x += level.prolongation * cycle(level.restriction * (b - a * x), l + 1);
    for (int s = 0; s < sweeps; ++s)
      for (Eigen::Index i = rows - 1; i >= 0; --i) relax(a, level, b, i, x);
    return x;
  }

  // A step of the method of Gauss and Seidel.
  static void relax(const Matrix_with_sums<Number>& a, const Level& level, const Vector& b,
                    Eigen::Index i, Vector& x) {
    x[i] += level.inverse[i] * (b[i] - a.times(x, i));
  }

  const Matrix_with_sums<Number>* finest_;
  std::vector<Level> levels_;
  std::variant<std::monostate, Cholesky_factorization<Number>, Laplacian_factorization> coarse_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_MULTIGRID_MULTIGRID_HIERARCHY_H
