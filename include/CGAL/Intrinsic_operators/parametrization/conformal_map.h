// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_CONFORMAL_MAP_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_CONFORMAL_MAP_H

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

/*!
\file
Maps to the plane with a free border that are as conformal as possible: they minimise the conformal
energy

    E = 1/2 integral of |grad w|^2 - area of the image = w^H C w,    w = x + i y

which is not negative, and zero if all angles stay the same. C is Hermitian: half the cotangent
Laplacian minus the area as a form on the border.

Several disks are mapped one by one, and lie beside each other, see `pack_components()`.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// C, with rows as the Laplacian
Eigen::SparseMatrix<std::complex<double>>
conformal_energy(const Eigen::SparseMatrix<double>& laplacian,
                 const std::vector<Disk_border>& borders);

// `progress` is called before each factorization and after each solution.
Eigen::MatrixX2d least_squares_conformal_map(const Face_table& table,
                                             const Eigen::SparseMatrix<double>& laplacian,
                                             const std::vector<Disk_border>& borders,
                                             Linear_solver solver,
                                             const std::function<bool(std::size_t)>& progress);
Eigen::MatrixX2d spectral_conformal_map(const Face_table& table,
                                        const Eigen::SparseMatrix<double>& laplacian,
                                        const std::vector<Disk_border>& borders,
                                        const std::function<bool(std::size_t)>& progress);

} // namespace internal

/*!
\brief assembles the matrix of the conformal energy of disks, see the head of the file.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation
\return a Hermitian, positive semidefinite matrix with a row and column per row of
  `t.input_vertex()`, without dimension
\throws Invalid_input if a face has no area, or a component is not a disk, see `circular_border()`
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
  requires NumberedTriangulation<Triangulation> Eigen::SparseMatrix<std::complex<double>>
  conformal_energy(const Triangulation& t) {
    return internal::conformal_energy(cotangent_laplacian(t), internal::disk_borders(t));
  }

/*!
\brief maps a disk to the plane with least conformal energy, two vertices fixed (Lévy, Petitjean,
Ray, Maillot, Least squares conformal maps, 2002).

The two are the border vertex where the longest edge of the border begins, and the border vertex
half the length of the border away. The result is scaled to the area of the surface, and the first
of them is at the origin.
If no conformal map exists, the result depends on the two vertices; that of
`spectral_conformal_map()` does not. Faces may turn over, and parts may overlap: `certify_map()`
finds out exactly.

\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\tparam NP a chain of named parameters
\param t the triangulation of a disk, or of several
\param solver how to solve the linear problem
\param np an optional named parameter:
  - `visitor(v)`: `v.progress(n)` is called before each factorization and after each solution, with
    the number of solutions, a `std::size_t`; it returns whether to go on
\return a point, x and y in the units of the input, per row of `t.input_vertex()`; isolated vertices
  are at (0, 0). If the visitor has ended the work, no points
\throws Invalid_input if a face has no area, or a component is not a disk, see `circular_border()`
\throws Indefinite_matrix if rounding makes the matrix indefinite
\complexity that of a sparse factorization of complex numbers
*/
template <MeasuredTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
  requires NumberedTriangulation<Triangulation> Eigen::MatrixX2d
  least_squares_conformal_map(const Triangulation& t, Linear_solver solver,
                              const NP& np = parameters::default_values()) {
    internal::expect_names<internal::tags::visitor>(np);
    const internal::Face_table table = internal::face_table(t);
    return internal::least_squares_conformal_map(
        table, cotangent_laplacian(t), internal::disk_borders(table, t.input().names().sheets),
        solver, internal::progress_of(np));
  }

/// maps a disk with the solver that `solver_for()` chooses; see above.
template <MeasuredTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
  requires NumberedTriangulation<Triangulation> Eigen::MatrixX2d
  least_squares_conformal_map(const Triangulation& t, const NP& np = parameters::default_values()) {
    return least_squares_conformal_map(t, Linear_solver::automatic, np);
  }

/*!
\brief maps a disk to the plane with least conformal energy for the extent of its border (Mullen,
Tong, Alliez, Desbrun, Spectral conformal parameterization, 2008).

It is the eigenvector of C w = lambda B w with the least eigenvalue among those with mean zero on
the border, where B is the length of the border at its vertices. No vertex is fixed: the result
follows the surface, turned so that the first vertex of the border (see `circular_border()`) is on
the positive x-axis, and is scaled to the area of the surface. `certify_map()` tells whether it is
injective.

\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\tparam NP a chain of named parameters
\param t the triangulation of a disk, or of several
\param np see `least_squares_conformal_map()`
\return a point, x and y in the units of the input, per row of `t.input_vertex()`; isolated vertices
  are at (0, 0). If the visitor has ended the work, no points
\throws Invalid_input if a face has no area, or a component is not a disk, see `circular_border()`
\throws Indefinite_matrix if rounding makes the matrix indefinite
\complexity that of a sparse factorization of complex numbers, and of some solutions
*/
template <MeasuredTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
  requires NumberedTriangulation<Triangulation> Eigen::MatrixX2d
  spectral_conformal_map(const Triangulation& t, const NP& np = parameters::default_values()) {
    internal::expect_names<internal::tags::visitor>(np);
    const internal::Face_table table = internal::face_table(t);
    return internal::spectral_conformal_map(table, cotangent_laplacian(t),
                                            internal::disk_borders(table, t.input().names().sheets),
                                            internal::progress_of(np));
  }

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(least_squares_conformal_map)
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(spectral_conformal_map)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_CONFORMAL_MAP_H
