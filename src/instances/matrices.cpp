// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Matrices of the usual triangulations.

#include <CGAL/Intrinsic_operators/compiled.h>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_OPERATORS_INSTANCES(template);

} // namespace CGAL::Intrinsic_triangulations
