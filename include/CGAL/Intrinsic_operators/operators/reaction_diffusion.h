// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_REACTION_DIFFUSION_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_REACTION_DIFFUSION_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds the coefficients of the equation  -a div grad u + c u = f  on a surface.
*/
struct Reaction_diffusion {
  double diffusion = 1; ///< a, positive
  double reaction = 0;  ///< c, not negative
};

namespace internal {

inline void check(const Reaction_diffusion& e) {
  if (!(e.diffusion > 0) || !(e.reaction >= 0) || !std::isfinite(e.diffusion) ||
      !std::isfinite(e.reaction))
    throw std::invalid_argument("diffusion must be positive, and reaction not negative");
}

// Whether all rows that have an area are of one component.
inline bool is_connected(const Eigen::SparseMatrix<double>& mass, const Eigen::VectorXd& area) {
  const std::vector<std::uint32_t> component = components_of_matrix(mass);
  std::size_t count = 0;
  for (std::uint32_t r = 0; r < component.size(); ++r)
    if (component[r] == r && area[r] > 0) ++count;
  return count <= 1;
}

} // namespace internal

/*!
\brief solves  -a div grad u + c u = f  for a piecewise linear function u, by the method of Galerkin:

    (a L + c M) u = b,    b_i = integral of f times the hat function of vertex i

with the cotangent Laplacian L and the Galerkin mass matrix M. The border condition is the natural one: no
flux. A point source at a vertex adds its strength to the load b there.

If c is zero, solutions differ by constants: the one of mean zero is returned.

\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\param equation the coefficients
\param load b, in the numbering of the input
\return values at the vertices, in the numbering of the input; zero at vertices without faces
\throws Invalid_input if a face has no area
\throws std::invalid_argument if a coefficient or the size of the load makes no sense; if c is zero and the
  load does not sum to zero, or the surface is not connected
\throws std::runtime_error if rounding has left no positive definite matrix
\complexity that of a sparse factorization
*/
template <MeasuredTriangulation Triangulation>
Eigen::VectorXd solve_reaction_diffusion(const Triangulation& t, const Reaction_diffusion& equation,
                                         const Eigen::VectorXd& load) {
  internal::check(equation);
  const Eigen::SparseMatrix<double> mass = galerkin_mass_matrix(t);
  if (load.size() != mass.rows())
    throw std::invalid_argument("the load must have an entry per vertex");
  Eigen::SparseMatrix<double> m = equation.diffusion * cotangent_laplacian(t);
  if (equation.reaction > 0) m += equation.reaction * mass;
  const Eigen::VectorXd area = mass.diagonal(); // up to a factor
  Eigen::VectorXd b = load;
  std::vector<std::uint32_t> without_area, fixed;
  for (std::uint32_t v = 0; v < area.size(); ++v)
    if (!(area[v] > 0)) without_area.push_back(v);
  for (const std::uint32_t v : without_area) b[v] = 0;
  fixed = without_area;
  if (equation.reaction == 0 && without_area.size() < static_cast<std::size_t>(area.size())) {
    if (!(std::abs(b.sum()) <= 1e-9 * b.cwiseAbs().sum()) || !internal::is_connected(mass, area))
      throw std::invalid_argument("without reaction, the load must sum to zero and the surface be "
                                  "connected, or there is no solution");
    // any value will do
    Eigen::Index largest = 0;
    area.maxCoeff(&largest);
    fixed.push_back(static_cast<std::uint32_t>(largest));
  }
  Eigen::VectorXd u = solve_with_fixed_values(
      m, b, fixed, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(fixed.size())));
  if (equation.reaction == 0) {
    u.array() -= (mass * u).sum() / mass.sum();
    for (const std::uint32_t v : without_area) u[v] = 0;
  }
  return u;
}

namespace internal {

inline void check_source(const Eigen::VectorXd& areas, std::uint32_t vertex) {
  if (std::int64_t{vertex} >= areas.size() || !(areas[vertex] > 0))
    throw std::invalid_argument("vertex " + std::to_string(vertex) +
                                " has no faces, and cannot be a source");
}

} // namespace internal

/*!
\brief computes the harmonic Green's function of a vertex: -div grad u = delta - 1/A with mean zero, where A
is the area of the surface (Fig. 26 of the course). On the border, the flux is zero.

Near the source u is -log(r) / alpha, where alpha is the total angle there: unbounded, but square integrable.
\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation of a connected surface
\param vertex the source, in the numbering of the input
\return values at the vertices, in the numbering of the input
\throws std::invalid_argument if the vertex has no faces, or the surface is not connected
\throws Invalid_input see `solve_reaction_diffusion()`
\complexity that of a sparse factorization
*/
template <MeasuredTriangulation Triangulation>
Eigen::VectorXd harmonic_green_function(const Triangulation& t, std::uint32_t vertex) {
  Eigen::VectorXd load = internal::areas_at_vertices(t);
  internal::check_source(load, vertex);
  load *= -1 / load.sum();
  load[vertex] += 1;
  return solve_reaction_diffusion(t, {.diffusion = 1, .reaction = 0}, load);
}

/*!
\brief computes the heat kernel of a vertex after a short time by one implicit Euler step:
u - time div grad u = delta (Fig. 26 of the course). On the border, the flux is zero.

The integral of u is 1. It decays like exp(-r / sqrt(time)), and near the source it is -log(r) / (alpha time),
where alpha is the total angle there.
\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\param vertex the source, in the numbering of the input
\param time the time, in units of area of the input
\return values at the vertices, in the numbering of the input
\throws std::invalid_argument if the vertex has no faces, or the time is not positive
\throws Invalid_input see `solve_reaction_diffusion()`
\complexity that of a sparse factorization
*/
template <MeasuredTriangulation Triangulation>
Eigen::VectorXd short_time_heat_kernel(const Triangulation& t, std::uint32_t vertex, double time) {
  const Eigen::VectorXd areas = internal::areas_at_vertices(t);
  internal::check_source(areas, vertex);
  return solve_reaction_diffusion(t, {.diffusion = time, .reaction = 1},
                                  Eigen::VectorXd::Unit(areas.size(), vertex));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_REACTION_DIFFUSION_H
