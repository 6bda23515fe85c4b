// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_POINT_SOURCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_POINT_SOURCES_H

#include <CGAL/Intrinsic_triangulations/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulations/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_triangulations/triangulation/MeasuredTriangulation.h>

#include <Eigen/Core>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace CGAL::Intrinsic_triangulations {

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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_POINT_SOURCES_H
