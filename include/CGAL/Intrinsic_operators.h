// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_H
#define CGAL_INTRINSIC_OPERATORS_H

/*!
\file
Includes finite element matrices, solvers, their applications (distances by heat, vectors, maps to
the plane, editing), and `CGAL/Intrinsic_triangulations.h`. Needs Eigen. Eigenfunctions also need
Spectra: `CGAL/Intrinsic_operators/solvers/eigenpairs.h`.
*/

#include <CGAL/Intrinsic_operators/compiled.h>
#include <CGAL/Intrinsic_operators/distance/Distances.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/distances_on_mesh.h>
#include <CGAL/Intrinsic_operators/distance/divide_among.h>
#include <CGAL/Intrinsic_operators/distance/heat_distances.h>
#include <CGAL/Intrinsic_operators/editing/Heat_flow.h>
#include <CGAL/Intrinsic_operators/editing/Surface_deformation.h>
#include <CGAL/Intrinsic_operators/editing/interpolate_harmonically.h>
#include <CGAL/Intrinsic_operators/elements/crouzeix_raviart.h>
#include <CGAL/Intrinsic_operators/elements/quadratic.h>
#include <CGAL/Intrinsic_operators/improvement/describe_delaunay.h>
#include <CGAL/Intrinsic_operators/improvement/improve.h>
#include <CGAL/Intrinsic_operators/improvement/improve_and_measure.h>
#include <CGAL/Intrinsic_operators/improvement/reports.h>
#include <CGAL/Intrinsic_operators/operators/Face_gradient.h>
#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/hodge_stars.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/matrix_market.h>
#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_operators/operators/residual_indicators.h>
#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_operators/parametrization/map_to_plane.h>
#include <CGAL/Intrinsic_operators/parametrization/measure_distortion.h>
#include <CGAL/Intrinsic_operators/parametrization/pack_components.h>
#include <CGAL/Intrinsic_operators/parametrization/parametrize.h>
#include <CGAL/Intrinsic_operators/parametrization/point_cloud_map.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/vectors/Point_cloud_vectors.h>
#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/Vector_options.h>
#include <CGAL/Intrinsic_operators/vectors/Vectors.h>
#include <CGAL/Intrinsic_operators/vectors/Vectors_on_sheets.h>
#include <CGAL/Intrinsic_operators/vectors/centres.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_operators/vectors/field_singularities.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_operators/vectors/logarithms_from_place.h>
#include <CGAL/Intrinsic_operators/vectors/principal_directions.h>
#include <CGAL/Intrinsic_triangulations.h>

#endif // CGAL_INTRINSIC_OPERATORS_H
