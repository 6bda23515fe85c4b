// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_SURFACE_MODES_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_SURFACE_MODES_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Twin_points.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Refuses the matrices of a surface so small that its eigenvalues are beyond doubles: they are of
// the size of the ratio of traces, and some far above it.
inline void expect_finite_eigenvalues(const Eigen::SparseMatrix<double>& laplacian,
                                      const Eigen::SparseMatrix<double>& mass) {
  constexpr double most = 0x1p1010; // a ten-thousandth of the greatest double
  const double trace = laplacian.diagonal().sum();
  if (trace > 0 && !(trace / mass.diagonal().sum() < most))
    throw Invalid_input(Element_kind::none, 0,
                        "the surface is so small that its eigenvalues, in 1 / area, are beyond "
                        "doubles; scale the mesh, to a size near 1");
}

} // namespace internal

/// More modes than a surface has are refused beyond so many of them: the dense solution of all
/// takes time by the third power of their number.
inline constexpr std::size_t most_modes_of_all = 1000;

/*!
\brief computes the smallest eigenvalues of the Laplacian of a surface, and their functions: squared
frequencies and modes.

They solve `L x = lambda M x`, with the cotangent Laplacian L and the lumped mass M, in the rows
that have a mass: an isolated vertex is no part of the surface, has no mode, and the value zero in
all functions. A point of a cloud at the place of an earlier one has the values of that.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\tparam NP a chain of named parameters
\param t the triangulation
\param count how many; of a surface with at most `most_modes_of_all` rows that have a mass all of
  them, if there are fewer
\param solver see `smallest_eigenpairs()`
\param np see `smallest_eigenpairs()`
\return the pairs, by rows of `t.input_vertex()`, in 1 / area of the input
\throws Invalid_input if a face has no area, if eigenvalues are beyond doubles, or if a larger
  surface has fewer, and as `smallest_eigenpairs()` does
\complexity that of `smallest_eigenpairs()`
*/
template <MeasuredTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Eigenpairs surface_modes(const Triangulation& t, std::size_t count, Linear_solver solver,
                         const NP& np = parameters::default_values()) {
  const Eigen::SparseMatrix<double> mass = lumped_mass_matrix(t), all = cotangent_laplacian(t);
  internal::expect_finite_eigenvalues(all, mass);
  std::vector<Eigen::Triplet<double>> chosen; // the columns of the rows with a mass
  for (Eigen::Index i = 0; i < mass.rows(); ++i)
    if (mass.coeff(i, i) > 0)
      chosen.emplace_back(static_cast<int>(i), static_cast<int>(chosen.size()), 1.);
  const auto size = static_cast<Eigen::Index>(chosen.size());
  if (count > chosen.size() && chosen.size() > most_modes_of_all)
    throw Invalid_input(Element_kind::none, 0,
                        "the surface has " + std::to_string(size) +
                            " vertices and as many eigenfunctions, not " + std::to_string(count) +
                            "; ask for fewer: some hundred take seconds");
  const auto most = static_cast<Eigen::Index>(std::min(count, chosen.size()));
  if (size == mass.rows()) return smallest_eigenpairs(all, mass, most, solver, np);
  Eigen::SparseMatrix<double> rows(mass.rows(), size);
  rows.setFromTriplets(chosen.begin(), chosen.end());
  const Eigen::SparseMatrix<double> back = rows.transpose();
  Eigen::SparseMatrix<double> laplacian = back * all * rows;
  laplacian.makeCompressed();
  Eigenpairs pairs = smallest_eigenpairs(laplacian, back * mass * rows, most, solver, np);
  pairs.vectors = rows * pairs.vectors;
  if (pairs.values.size() > 0) Twin_points(t).copy(pairs.vectors);
  return pairs;
}

/// computes them with the solver that `solver_for()` chooses; see above.
template <MeasuredTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Eigenpairs surface_modes(const Triangulation& t, std::size_t count,
                         const NP& np = parameters::default_values()) {
  return surface_modes(t, count, Linear_solver::automatic, np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_SURFACE_MODES_H
