// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What improves and measures the usual triangulations.

#include <CGAL/Intrinsic_operators/improvement/improve.h>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_FOR_EXACT(CGAL_INTRINSIC_OPERATORS_IMPROVEMENTS, template);
CGAL_INTRINSIC_TRIANGULATIONS_FOR_ROUNDED(CGAL_INTRINSIC_OPERATORS_IMPROVEMENTS, template);

} // namespace CGAL::Intrinsic_triangulations
