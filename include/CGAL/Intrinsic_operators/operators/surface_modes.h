// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_SURFACE_MODES_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_SURFACE_MODES_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief computes the smallest eigenvalues of the Laplacian of a surface, and their functions: squared
frequencies and modes.

They solve `L x = lambda M x`, with the cotangent Laplacian L and the lumped mass M. The mass of an
isolated vertex is zero; it gets the mean of all, and so one function that is zero elsewhere.
\tparam Triangulation a model of `MeasuredTriangulation`
\tparam NP a chain of named parameters
\param t the triangulation
\param count how many; all of them if there are fewer
\param np see `smallest_eigenpairs()`
\return the pairs, by rows of `t.input_vertex()`, in 1 / area of the input
\throws Invalid_input if a face has no area, and as `smallest_eigenpairs()` does
\complexity that of `smallest_eigenpairs()`
*/
template <MeasuredTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Eigenpairs surface_modes(const Triangulation& t, std::size_t count,
                         const NP& np = parameters::default_values()) {
  const Eigen::SparseMatrix<double> laplacian = cotangent_laplacian(t);
  Eigen::SparseMatrix<double> mass = lumped_mass_matrix(t);
  const double mean =
      mass.diagonal().sum() / static_cast<double>(std::max<Eigen::Index>(mass.rows(), 1));
  for (Eigen::Index i = 0; i < mass.rows(); ++i)
    if (!(mass.coeff(i, i) > 0)) mass.coeffRef(i, i) = mean;
  return smallest_eigenpairs(laplacian, mass,
                             std::min(static_cast<Eigen::Index>(count), laplacian.rows()), np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_SURFACE_MODES_H
