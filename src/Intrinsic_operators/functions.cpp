// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What solves for functions and for positions.

#define CGAL_INTRINSIC_TRIANGULATIONS_IN_FUNCTIONS 1

#include <CGAL/Intrinsic_operators/distance/Heat_solver.h>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>
#include <CGAL/Intrinsic_operators/editing/Surface_deformation.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_operators/parametrization/point_cloud_map.h>
