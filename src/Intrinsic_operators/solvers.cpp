// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Solvers of linear systems.

#define CGAL_INTRINSIC_TRIANGULATIONS_IN_SOLVERS 1

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
