// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The usual triangulations.

#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE template
#include <CGAL/Intrinsic_triangulation.h>
