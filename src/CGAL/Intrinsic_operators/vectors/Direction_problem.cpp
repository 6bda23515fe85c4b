// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs/Inverse_lanczos.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_operators/vectors/Direction_problem.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
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
    if (!progress(Direction_step::factored)) return {};
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
    free = Inverse_lanczos(factor_, masses_, part_).smallest(free, [&progress] {
      return progress(Direction_step::improved);
    });
    if (free.size() == 0) return free;
    return z + free;
  }

private:
  Eigen::Index part(Eigen::Index i) const {
    return static_cast<Eigen::Index>(part_[static_cast<std::size_t>(i)]);
  }
  double mass(Eigen::Index i) const { return masses_[i]; }

  // Small, but it makes flat surfaces, with eigenvalue zero, definite, and others follow their
  // guide to twelve digits. Eigenvectors alone do not depend on it: a larger one keeps rounding of
  // products with the matrix below the residual of an iteration.
  double least_shift(const Direction_problem& problem) const {
    const bool are_eigenvectors = problem.fixed.empty() && (problem.guide.array() == 0.).all();
    const bool is_direct =
        chosen_solver(problem.solver, problem.guide.size()) == Linear_solver::direct;
    return are_eigenvectors && !is_direct ? 0x1p-12 : 0x1p-26;
  }

  // The factored matrix, with ones for fixed vertices; sets the right side.
  Chosen_factorization<Complex> factored(const Direction_problem& problem) {
    const double shift =
        (std::min(problem.strength, 1e12) + least_shift(problem)) / graph_.squared_mean_length;
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
    return chosen_factorization(std::move(m), problem.solver);
  }

  const Connection_graph& graph_;
  std::vector<std::uint32_t> part_;
  Eigen::VectorXd masses_;
  Eigen::VectorXcd right_;
  Chosen_factorization<Complex> factor_;
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
