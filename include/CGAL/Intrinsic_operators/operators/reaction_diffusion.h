// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_REACTION_DIFFUSION_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_REACTION_DIFFUSION_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds the coefficients of the equation  -a div grad u + c u = f  on a surface.
*/
struct Reaction_diffusion {
  double diffusion = 1; ///< a, positive
  double reaction = 0;  ///< c, not negative
};

namespace internal {

// \throws std::invalid_argument if a coefficient is out of its range
void check(const Reaction_diffusion& e);

// \param mass the Galerkin mass matrix
Eigen::VectorXd solve_reaction_diffusion(const Eigen::SparseMatrix<double>& laplacian,
                                         const Eigen::SparseMatrix<double>& mass,
                                         const Reaction_diffusion& equation,
                                         const Eigen::VectorXd& load, Linear_solver solver);

} // namespace internal

/*!
\brief solves -a div grad u + c u = f for a piecewise linear function u, by the method of Galerkin:

    (a L + c M) u = b,    b_i = integral of f times the hat function of vertex i

with the cotangent Laplacian L and the Galerkin mass matrix M. The border condition is the natural
one: no flux. A point source at a vertex adds its strength to the load b there.

If c is zero, solutions differ by constants: the one of mean zero is returned.

\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\param equation the coefficients
\param load b, in the numbering of the input
\param solver how to solve the linear problem
\return values at the vertices, in the numbering of the input; zero at vertices without faces
\throws Invalid_input if a face has no area
\throws std::invalid_argument if a coefficient is out of its range, or the load has the wrong size;
  if c is zero and the load does not sum to zero, or the surface is not connected
\throws std::runtime_error if rounding makes the matrix indefinite; or if you asked for an
  iteration, and it does not converge
\complexity that of a sparse factorization
*/
template <MeasuredTriangulation Triangulation>
Eigen::VectorXd solve_reaction_diffusion(const Triangulation& t, const Reaction_diffusion& equation,
                                         const Eigen::VectorXd& load,
                                         Linear_solver solver = Linear_solver::automatic) {
  internal::check(equation);
  return internal::solve_reaction_diffusion(cotangent_laplacian(t), galerkin_mass_matrix(t),
                                            equation, load, solver);
}

namespace internal {

void check_source(const Eigen::VectorXd& areas, std::uint32_t vertex);

} // namespace internal

/*!
\brief computes the harmonic Green's function of a vertex: -div grad u = delta - 1/A with mean zero,
where A is the area of the surface (Fig. 26 of the course). On the border, the flux is zero.

Near the source u is -log(r) / alpha, where alpha is the total angle there: unbounded, but square
integrable.
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

The integral of u is 1. It decays like exp(-r / sqrt(time)), and near the source it is -log(r) /
(alpha time), where alpha is the total angle there.
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
