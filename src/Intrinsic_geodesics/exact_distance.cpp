// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact distances, which know nothing of the type of a triangulation.

#include <CGAL/Intrinsic_geodesics/distance/Window_propagation_impl.h>
