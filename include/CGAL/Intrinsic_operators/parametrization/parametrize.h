// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_PARAMETRIZE_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_PARAMETRIZE_H

#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>

#include <cstdint>
#include <stdexcept>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// How a disk is mapped to the plane.
enum class Map_method : std::uint8_t {
  harmonic,      ///< see `injective_harmonic_map()`
  least_squares, ///< see `least_squares_conformal_map()`
  spectral       ///< see `spectral_conformal_map()`
};

/*!
\brief certifies a map of a triangulation that stays as it is.
\param t the triangulation
\param uv a point per row; none: the visitor of the map has ended the work
\return the map. Its status is `inaccurate` if faces have turned over or have no area; `cancelled`
  without points
\complexity that of `certify_map()`
*/
template <MeasuredTriangulation Triangulation>
Injective_map certified_map(const Triangulation& t, Eigen::MatrixX2d uv) {
  if (uv.rows() == 0) return {Status::cancelled, std::move(uv), {}};
  Injective_map map{Status::done, std::move(uv), {}};
  map.certificate = certify_map(t, map.uv);
  if (!map.certificate.is_locally_injective()) map.status = Status::inaccurate;
  return map;
}

namespace internal {

inline void expect_factor_of_spectral_map(Linear_solver solver) {
  if (solver == Linear_solver::iterative)
    throw std::invalid_argument(
        "the matrix of a spectral map is singular but for a billionth, so that iterations do not "
        "converge; take a direct solver, or another method");
}

} // namespace internal

/*!
\brief maps a disk, or several, to the plane, and certifies the map.

Any other surface is cut open before:

    const Opened_input disks = cut_to_disks(sheet_of_cover(definition_of(t.input())));
    Intrinsic_triangulation<> opened(disks.input);
    const Injective_map map = parametrize(opened, Map_method::least_squares);

\param t the triangulation. Harmonic maps are made injective by flips and splits of edges
\param method how
\param solver how to solve the linear problems
\param np named parameters of the map, see `Map_method`
\return the map. The status of a harmonic one is that of `injective_harmonic_map()`, of others that
  of `certified_map()`
\throws std::invalid_argument if you ask to iterate for a spectral map
\throws Invalid_input and others as the functions do that `Map_method` names
\complexity that of the map and of its certificate
*/
template <RefinableTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Injective_map parametrize(Triangulation& t, Map_method method, Linear_solver solver,
                          const NP& np = parameters::default_values()) {
  switch (method) {
  case Map_method::least_squares:
    return certified_map(t, least_squares_conformal_map(t, solver, np));
  case Map_method::spectral:
    internal::expect_factor_of_spectral_map(solver);
    return certified_map(t, spectral_conformal_map(t, np));
  case Map_method::harmonic:
    break;
  }
  return injective_harmonic_map(t, circular_border(t), solver, np);
}

/// maps disks with the solver that `solver_for()` chooses; see above.
template <RefinableTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Injective_map parametrize(Triangulation& t, Map_method method,
                          const NP& np = parameters::default_values()) {
  return parametrize(t, method, Linear_solver::automatic, np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_PARAMETRIZE_H
