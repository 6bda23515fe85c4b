// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Solvers of linear systems.

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization_impl.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver_impl.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization_impl.h>
