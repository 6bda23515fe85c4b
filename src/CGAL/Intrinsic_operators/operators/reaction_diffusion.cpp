// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

void check(const Reaction_diffusion& e) {
  if (!(e.diffusion > 0) || !(e.reaction >= 0) || !std::isfinite(e.diffusion) ||
      !std::isfinite(e.reaction))
    throw std::invalid_argument("diffusion must be positive, and reaction not negative");
}

// Whether all rows with an area are in one component.
static bool is_connected(const Eigen::SparseMatrix<double>& mass, const Eigen::VectorXd& area) {
  const std::vector<std::uint32_t> component = components_of_matrix(mass);
  std::size_t count = 0;
  for (std::uint32_t r = 0; r < component.size(); ++r)
    if (component[r] == r && area[r] > 0) ++count;
  return count <= 1;
}

Eigen::VectorXd solve_reaction_diffusion(const Eigen::SparseMatrix<double>& laplacian,
                                         const Eigen::SparseMatrix<double>& mass,
                                         const Reaction_diffusion& equation,
                                         const Eigen::VectorXd& load, Linear_solver solver) {
  if (load.size() != mass.rows())
    throw std::invalid_argument("the load must have an entry per vertex");
  Eigen::SparseMatrix<double> m = equation.diffusion * laplacian;
  if (equation.reaction > 0) m += equation.reaction * mass;
  const Eigen::VectorXd area = mass.diagonal(); // up to a factor
  Eigen::VectorXd b = load;
  std::vector<std::uint32_t> without_area, fixed;
  for (std::uint32_t v = 0; v < area.size(); ++v)
    if (!(area[v] > 0)) without_area.push_back(v);
  for (const std::uint32_t v : without_area) b[v] = 0;
  fixed = without_area;
  if (equation.reaction == 0 && without_area.size() < static_cast<std::size_t>(area.size())) {
    // 1e-9 bounds the rounding of sums of nine million values
    if (!(std::abs(b.sum()) <= 1e-9 * b.cwiseAbs().sum()) || !is_connected(mass, area))
      throw std::invalid_argument("without reaction, the load must sum to zero and the surface be "
                                  "connected, or there is no solution");
    // any value will do
    Eigen::Index largest = 0;
    area.maxCoeff(&largest);
    fixed.push_back(static_cast<std::uint32_t>(largest));
  }
  Eigen::VectorXd u = Intrinsic_triangulations::solve_with_fixed_values(
      m, b, fixed, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(fixed.size())), solver);
  if (equation.reaction == 0) {
    u.array() -= (mass * u).sum() / mass.sum();
    for (const std::uint32_t v : without_area) u[v] = 0;
  }
  return u;
}

void check_source(const Eigen::VectorXd& areas, std::uint32_t vertex) {
  if (std::int64_t{vertex} >= areas.size() || !(areas[vertex] > 0))
    throw std::invalid_argument("vertex " + std::to_string(vertex) +
                                " has no faces, and cannot be a source");
}

} // namespace CGAL::Intrinsic_triangulations::internal
