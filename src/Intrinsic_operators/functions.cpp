// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What solves for functions and for positions.

#include <CGAL/Intrinsic_operators/distance/Heat_solver_impl.h>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_solver_impl.h>
#include <CGAL/Intrinsic_operators/editing/Surface_deformation_impl.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map_impl.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map_impl.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border_impl.h>
#include <CGAL/Intrinsic_operators/parametrization/point_cloud_map_impl.h>
