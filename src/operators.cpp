// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Solvers of linear and eigenvalue problems, and what is solved with them.

#include <CGAL/Intrinsic_triangulations/applications/distance/Heat_solver_impl.h>
#include <CGAL/Intrinsic_triangulations/applications/distance/Pinned_laplacian_impl.h>
#include <CGAL/Intrinsic_triangulations/applications/distance/Signed_heat_solver_impl.h>
#include <CGAL/Intrinsic_triangulations/applications/editing/Surface_deformation_impl.h>
#include <CGAL/Intrinsic_triangulations/applications/parametrization/certify_map_impl.h>
#include <CGAL/Intrinsic_triangulations/applications/parametrization/conformal_map_impl.h>
#include <CGAL/Intrinsic_triangulations/applications/parametrization/disk_border_impl.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Cholesky_factorization_impl.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Fixed_values_solver_impl.h>
#include <CGAL/Intrinsic_triangulations/operators/solvers/Laplacian_factorization_impl.h>
#if __has_include(<Spectra/SymGEigsShiftSolver.h>)
#include <CGAL/Intrinsic_triangulations/operators/solvers/eigenpairs_impl.h>
#endif
