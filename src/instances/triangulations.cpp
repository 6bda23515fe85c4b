// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The usual triangulations.

#include <CGAL/Intrinsic_triangulations/compiled.h>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES(template);

} // namespace CGAL::Intrinsic_triangulations
