// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact triangulations with other correspondences than integers, and what most programs do with them.

#include <CGAL/Intrinsic_triangulations/compiled.h>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_MODEL_INSTANCES(template);

} // namespace CGAL::Intrinsic_triangulations
