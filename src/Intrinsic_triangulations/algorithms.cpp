// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What most programs do with the usual triangulations.

#define CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE template
#include <CGAL/Intrinsic_triangulations/compiled_algorithms.h>
