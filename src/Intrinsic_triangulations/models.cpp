// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The other correspondences.

#include <CGAL/Intrinsic_triangulations/compiled_algorithms.h>

#undef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE template
#undef CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE
#define CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE template
#include <CGAL/Intrinsic_triangulations/compiled_models.h>
