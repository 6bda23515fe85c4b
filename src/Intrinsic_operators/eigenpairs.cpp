// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Eigenvalues and eigenvectors.

#if __has_include(<Spectra/SymGEigsShiftSolver.h>)
#include <CGAL/Intrinsic_operators/solvers/eigenpairs_impl.h>
#endif
