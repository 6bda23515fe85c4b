// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_operators/vectors/Direction_problem.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Smoothest fields in the parts of a surface. In parts without constraints it is the eigenvector of
// the smallest eigenvalue.
class Direction_solver {
  using Complex = std::complex<double>;

public:
  Direction_solver(const Direction_problem& problem, const Connection_graph& graph)
      : graph_(graph), part_(graph.parts()), masses_(positive_masses(graph)),
        right_(Eigen::VectorXcd::Zero(problem.guide.size())), factor_(factored(problem)) {}

  // \return empty if cancelled
  Eigen::VectorXcd solve(const std::function<bool(Direction_step)>& progress) const {
    if (progress && !progress(Direction_step::factored)) return {};
    std::vector<char> has_wishes(graph_.size, 0); // by part
    for (Eigen::Index i = 0; i < right_.size(); ++i)
      if (right_[i] != 0.) has_wishes[static_cast<std::size_t>(part(i))] = 1;
    Eigen::VectorXcd z = factor_.solve(right_), free = Eigen::VectorXcd::Zero(z.size());
    std::mt19937 random(1); // any start will do
    bool is_free = false;
    for (Eigen::Index i = 0; i < z.size(); ++i) {
      if (has_wishes[static_cast<std::size_t>(part(i))] != 0) continue;
      is_free = true;
      const double x = static_cast<double>(random()), y = static_cast<double>(random());
      free[i] = Complex(x, y) * 0x1p-31 - Complex(1, 1);
    }
    if (!is_free) return z;
    free = smallest_eigenvectors(free, progress);
    if (free.size() == 0) return free;
    return z + free;
  }

private:
  Eigen::Index part(Eigen::Index i) const {
    return static_cast<Eigen::Index>(part_[static_cast<std::size_t>(i)]);
  }
  double mass(Eigen::Index i) const { return masses_[i]; }

  // The factored matrix, with ones for fixed vertices; sets the right side.
  Cholesky_factorization<Complex> factored(const Direction_problem& problem) {
    // small, but it makes flat surfaces, with eigenvalue zero, definite, and others follow their
    // guide to twelve digits
    const double shift = (std::min(problem.strength, 1e12) + 0x1p-26) / graph_.squared_mean_length;
    for (Eigen::Index i = 0; i < right_.size(); ++i) right_[i] = mass(i) * problem.guide[i];
    std::vector<char> is_fixed(graph_.size, 0);
    Eigen::VectorXcd values = Eigen::VectorXcd::Zero(right_.size());
    for (const auto& [i, z] : problem.fixed) {
      is_fixed[i] = 1;
      values[static_cast<Eigen::Index>(i)] = z;
    }
    Eigen::SparseMatrix<Complex> m = scaled_laplacian<Complex>(graph_, problem.degree, 1);
    for (int i = 0; i < m.cols(); ++i) m.coeffRef(i, i) += shift * mass(i);
    right_ -= m * values;
    for (const auto& [i, z] : problem.fixed)
      right_[static_cast<Eigen::Index>(i)] = values[static_cast<Eigen::Index>(i)];
    m = with_fixed_rows(std::move(m), is_fixed);
    return raised_factorization(m);
  }

  // By the method of Lanczos with the inverse, in all parts at once, independently in each.
  Eigen::VectorXcd
  smallest_eigenvectors(Eigen::VectorXcd z,
                        const std::function<bool(Direction_step)>& progress) const {
    for (int round = 0; round < 8; ++round) {
      if (improve(z)) break;
      if (progress && !progress(Direction_step::improved)) return {};
    }
    return z;
  }

  // Replaces vectors by the best combinations of some powers of the inverse applied to them;
  // returns whether they are eigenvectors.
  bool improve(Eigen::VectorXcd& z) const {
    constexpr int steps = 16;
    Eigen::MatrixXcd basis(z.size(), steps);
    Eigen::MatrixXd diagonal = Eigen::MatrixXd::Zero(z.size(), steps), beside = diagonal;
    basis.col(0) = z;
    divide(basis.col(0), norms(z));
    for (int j = 0; j < steps; ++j) {
      Eigen::VectorXcd next(z.size());
      for (Eigen::Index i = 0; i < z.size(); ++i) next[i] = mass(i) * basis(i, j);
      next = factor_.solve(next);
      for (int k = j; k >= 0; --k) { // all of them, since rounding makes them not orthogonal
        const Eigen::VectorXcd c = products(basis.col(k), next);
        if (k == j) diagonal.col(j) = c.real();
        for (Eigen::Index i = 0; i < z.size(); ++i) next[i] -= c[part(i)] * basis(i, k);
      }
      Eigen::VectorXd norm = norms(next);
      for (Eigen::Index i = 0; i < z.size(); ++i) // rounding errors are no direction
        if (norm[i] <= 1e-13 * diagonal(i, 0)) norm[i] = 0;
      beside.col(j) = norm;
      if (j + 1 == steps) break;
      basis.col(j + 1) = next;
      divide(basis.col(j + 1), norm);
    }
    return combine(basis, diagonal, beside, z);
  }

  // The greatest eigenvectors of tridiagonal matrices, a row of entries for each part, as sums of
  // vectors of the basis.
  bool combine(const Eigen::MatrixXcd& basis, const Eigen::MatrixXd& diagonal,
               const Eigen::MatrixXd& beside, Eigen::VectorXcd& z) const {
    const Eigen::Index last = diagonal.cols() - 1;
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(z.size(), last + 1);
    bool is_done = true;
    for (Eigen::Index p = 0; p < z.size(); ++p) {
      if (!(diagonal(p, 0) > 0)) continue; // represents no part, or a part without constraints
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
      solver.computeFromTridiagonal(diagonal.row(p), beside.row(p).head(last));
      weights.row(p) = solver.eigenvectors().col(last);
      const double residual = beside(p, last) * std::abs(weights(p, last));
      is_done = is_done && residual <= 1e-7 * solver.eigenvalues()[last];
    }
    for (Eigen::Index i = 0; i < z.size(); ++i)
      z[i] = basis.row(i).transpose().cwiseProduct(weights.row(part(i)).transpose()).sum();
    return is_done;
  }

  // inner products in each part, at its representative vertex
  Eigen::VectorXcd products(const Eigen::VectorXcd& x, const Eigen::VectorXcd& y) const {
    Eigen::VectorXcd result = Eigen::VectorXcd::Zero(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) result[part(i)] += mass(i) * std::conj(x[i]) * y[i];
    return result;
  }
  Eigen::VectorXd norms(const Eigen::VectorXcd& x) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) result[part(i)] += mass(i) * std::norm(x[i]);
    return result.cwiseSqrt();
  }
  // in each part by its norm, or by nothing
  void divide(Eigen::Ref<Eigen::VectorXcd> x, const Eigen::VectorXd& norm) const {
    for (Eigen::Index i = 0; i < x.size(); ++i)
      x[i] = norm[part(i)] > 0 ? Complex(x[i] / norm[part(i)]) : 0;
  }

  const Connection_graph& graph_;
  std::vector<std::uint32_t> part_;
  Eigen::VectorXd masses_;
  Eigen::VectorXcd right_;
  Cholesky_factorization<Complex> factor_;
};

std::vector<std::complex<double>> solve(const Direction_problem& problem,
                                        const Connection_graph& graph,
                                        const std::function<bool(Direction_step)>& progress) {
  const Eigen::VectorXcd z = Direction_solver(problem, graph).solve(progress);
  if (z.size() == 0) return {};
  std::vector<std::complex<double>> result(graph.size);
  for (std::size_t i = 0; i < graph.size; ++i) {
    if (!(graph.areas[i] > 0)) continue;
    result[i] = unit_vector(z[static_cast<Eigen::Index>(i)]);
    if (result[i] == 0.) result[i] = 1; // where the field vanishes, any direction will do
  }
  return result;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
