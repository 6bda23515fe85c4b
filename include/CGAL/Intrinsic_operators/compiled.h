// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_COMPILED_H
#define CGAL_INTRINSIC_OPERATORS_COMPILED_H

/*!
\file
Declares the matrices that the library has instantiated for the usual triangulations, as
`CGAL/Intrinsic_triangulations/compiled.h` does for triangulations. `CGAL/Intrinsic_operators.h`
includes this file.
*/

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/compiled.h>

#include <Eigen/SparseCore>

/// \cond
// instantiates the matrices of a triangulation.
#define CGAL_INTRINSIC_OPERATORS_MATRICES(prefix, ...)                                             \
  prefix Eigen::SparseMatrix<double> cotangent_laplacian(const __VA_ARGS__&);                      \
  prefix Eigen::SparseMatrix<double> lumped_mass_matrix(const __VA_ARGS__&);                       \
  prefix Eigen::SparseMatrix<double> galerkin_mass_matrix(const __VA_ARGS__&)
// instantiates them for the usual triangulations with a correspondence.
#define CGAL_INTRINSIC_OPERATORS_INSTANCES(prefix)                                                 \
  CGAL_INTRINSIC_TRIANGULATIONS_FOR_INTEGERS(CGAL_INTRINSIC_OPERATORS_MATRICES, prefix)

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_OPERATORS_INSTANCES(extern template);

} // namespace CGAL::Intrinsic_triangulations
#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
/// \endcond

#endif // CGAL_INTRINSIC_OPERATORS_COMPILED_H
