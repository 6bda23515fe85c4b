// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOURCES_H
#define CGAL_INTRINSIC_OPERATORS_SOURCES_H

/*!
\file
All sources of the package `Intrinsic_operators` and of those below it, for programs that do not link the library: exactly one of
their sources includes this file.
*/

#include <CGAL/Intrinsic_geodesics_sources.h>
#include <CGAL/Intrinsic_operators/distance/Distances.cpp>
#include <CGAL/Intrinsic_operators/distance/Heat_solver.cpp>
#include <CGAL/Intrinsic_operators/distance/Pinned_laplacian.cpp>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.cpp>
#include <CGAL/Intrinsic_operators/distance/distance_sources.cpp>
#include <CGAL/Intrinsic_operators/distance/heat_distances.cpp>
#include <CGAL/Intrinsic_operators/editing/Heat_flow.cpp>
#include <CGAL/Intrinsic_operators/editing/Surface_deformation.cpp>
#include <CGAL/Intrinsic_operators/elements/crouzeix_raviart.cpp>
#include <CGAL/Intrinsic_operators/elements/quadratic.cpp>
#include <CGAL/Intrinsic_operators/improvement/reports.cpp>
#include <CGAL/Intrinsic_operators/operators/Face_gradient.cpp>
#include <CGAL/Intrinsic_operators/operators/matrix_market.cpp>
#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.cpp>
#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.cpp>
#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.cpp>
#include <CGAL/Intrinsic_operators/operators/transfer.cpp>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.cpp>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.cpp>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.cpp>
#include <CGAL/Intrinsic_operators/parametrization/measure_distortion.cpp>
#include <CGAL/Intrinsic_operators/parametrization/pack_components.cpp>
#include <CGAL/Intrinsic_operators/parametrization/point_cloud_map.cpp>
#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.cpp>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.cpp>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs/Block_eigensolver.cpp>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs/Inverse_lanczos.cpp>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs/eigenpairs.cpp>
#include <CGAL/Intrinsic_operators/solvers/elimination/Cholesky_factorization.cpp>
#include <CGAL/Intrinsic_operators/solvers/elimination/Dense_product.cpp>
#include <CGAL/Intrinsic_operators/solvers/elimination/Laplacian_factorization.cpp>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.cpp>
#include <CGAL/Intrinsic_operators/solvers/multigrid/Hermitian_factorizations.cpp>
#include <CGAL/Intrinsic_operators/solvers/multigrid/Multigrid_factorization.cpp>
#include <CGAL/Intrinsic_operators/vectors/Direction_problem.cpp>
#include <CGAL/Intrinsic_operators/vectors/Heat_transport.cpp>
#include <CGAL/Intrinsic_operators/vectors/Point_cloud_vectors.cpp>
#include <CGAL/Intrinsic_operators/vectors/Vectors.cpp>
#include <CGAL/Intrinsic_operators/vectors/principal_directions.cpp>

#endif // CGAL_INTRINSIC_OPERATORS_SOURCES_H
