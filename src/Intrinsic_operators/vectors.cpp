// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What solves for tangent vectors.

#define CGAL_INTRINSIC_TRIANGULATIONS_IN_VECTORS 1

#include <CGAL/Intrinsic_operators/vectors/Direction_problem.h>
#include <CGAL/Intrinsic_operators/vectors/Heat_transport_impl.h>
#include <CGAL/Intrinsic_operators/vectors/Point_cloud_vectors.h>
