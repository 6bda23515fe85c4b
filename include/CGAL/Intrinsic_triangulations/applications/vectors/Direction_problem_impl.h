// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_DIRECTION_PROBLEM_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_DIRECTION_PROBLEM_IMPL_H

#include <CGAL/Intrinsic_triangulations/applications/vectors/Direction_problem.h>
#include <CGAL/Intrinsic_triangulations/applications/vectors/factored_laplacian.h>
#include <CGAL/Intrinsic_triangulations/applications/vectors/graph_parts.h>
#include <CGAL/Intrinsic_triangulations/applications/vectors/unit_vector.h>
#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Cholesky_factorization.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Smoothest fields in the parts of a surface, some of which have no wishes: there, the eigenvector of the smallest eigenvalue.
class Direction_solver {
  using Complex = std::complex<double>;

public:
  Direction_solver(const Direction_problem& problem, const Connection_graph& graph)
      : graph_(graph), part_(graph_parts(graph)), masses_(positive_masses(graph)),
        is_fixed_(graph.size, 0), right_(Eigen::VectorXcd::Zero(problem.guide.size())),
        factor_(factored(problem)) {}

  Eigen::VectorXcd solve() const {
    std::vector<char> has_wishes(graph_.size, 0); // by part
    for (Eigen::Index i = 0; i < right_.size(); ++i)
      if (right_[i] != 0.) has_wishes[part(i)] = 1;
    Eigen::VectorXcd z = factor_.solve(right_), free = Eigen::VectorXcd::Zero(z.size());
    std::mt19937 random(1); // any start will do
    bool is_free = false;
    for (Eigen::Index i = 0; i < z.size(); ++i) {
      if (has_wishes[part(i)] != 0) continue;
      is_free = true;
      const double x = static_cast<double>(random()), y = static_cast<double>(random());
      free[i] = Complex(x, y) * 0x1p-31 - Complex(1, 1);
    }
    if (is_free) z += smallest_eigenvectors(free);
    return z;
  }

private:
  std::size_t part(Eigen::Index i) const { return part_[static_cast<std::size_t>(i)]; }
  double mass(Eigen::Index i) const { return masses_[static_cast<std::size_t>(i)]; }

  // The factored matrix, with ones for what is fixed; sets the right side.
  Cholesky_factorization<Complex> factored(const Direction_problem& problem) {
    // so little that flat surfaces, with eigenvalue zero, are definite
    const double shift = (problem.strength + 0x1p-26) / graph_.squared_mean_length;
    for (Eigen::Index i = 0; i < right_.size(); ++i) right_[i] = mass(i) * problem.guide[i];
    Eigen::VectorXcd values = Eigen::VectorXcd::Zero(right_.size());
    for (const auto& [i, z] : problem.fixed) {
      is_fixed_[i] = 1;
      values[static_cast<Eigen::Index>(i)] = z;
    }
    std::vector<double> shifts = masses_;
    for (double& s : shifts) s *= shift;
    return factored_laplacian<Complex>(
        graph_, problem.degree, 1, shifts,
        [&](Eigen::SparseMatrix<Complex>& m) { eliminate(values, m); });
  }

  void eliminate(const Eigen::VectorXcd& values, Eigen::SparseMatrix<Complex>& m) {
    right_ -= m * values;
    const auto is_fixed = [this](Eigen::Index i) {
      return is_fixed_[static_cast<std::size_t>(i)] != 0;
    };
    for (Eigen::Index i = 0; i < right_.size(); ++i)
      if (is_fixed(i)) right_[i] = values[i];
    m.prune([&](Eigen::Index i, Eigen::Index j, const Complex&) {
      return i == j || (!is_fixed(i) && !is_fixed(j));
    });
    for (Eigen::Index i = 0; i < right_.size(); ++i)
      if (is_fixed(i)) m.coeffRef(i, i) = 1;
  }

  // By inverse power iteration, in every part for itself.
  Eigen::VectorXcd smallest_eigenvectors(Eigen::VectorXcd z) const {
    normalize(z);
    for (int step = 0; step < 100; ++step) {
      Eigen::VectorXcd next(z.size());
      for (Eigen::Index i = 0; i < z.size(); ++i) next[i] = mass(i) * z[i];
      next = factor_.solve(next);
      normalize(next);
      const double change = (next - z).lpNorm<Eigen::Infinity>();
      z.swap(next);
      if (change <= 1e-6 * z.lpNorm<Eigen::Infinity>()) break;
    }
    return z;
  }

  void normalize(Eigen::VectorXcd& z) const {
    std::vector<double> square(graph_.size, 0);
    for (Eigen::Index i = 0; i < z.size(); ++i) square[part(i)] += mass(i) * std::norm(z[i]);
    for (Eigen::Index i = 0; i < z.size(); ++i)
      if (square[part(i)] > 0) z[i] /= std::sqrt(square[part(i)]);
  }

  const Connection_graph& graph_;
  std::vector<std::size_t> part_;
  std::vector<double> masses_;
  std::vector<char> is_fixed_;
  Eigen::VectorXcd right_;
  Cholesky_factorization<Complex> factor_;
};

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::vector<std::complex<double>> solve(const Direction_problem& problem,
                                        const Connection_graph& graph) {
  const Eigen::VectorXcd z = Direction_solver(problem, graph).solve();
  std::vector<std::complex<double>> result(graph.size);
  for (std::size_t i = 0; i < graph.size; ++i) {
    if (!(graph.areas[i] > 0)) continue;
    result[i] = unit_vector(z[static_cast<Eigen::Index>(i)]);
    if (result[i] == 0.) result[i] = 1; // where the field vanishes, any direction is as good
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_DIRECTION_PROBLEM_IMPL_H
