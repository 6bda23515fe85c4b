// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves and distances on the usual triangulations.

#include <CGAL/Intrinsic_geodesics/compiled.h>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_GEODESICS_INSTANCES(template);

} // namespace CGAL::Intrinsic_triangulations
