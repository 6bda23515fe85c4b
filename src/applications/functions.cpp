// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What solves for functions and for positions.

#include <CGAL/Intrinsic_triangulations/applications/distance/Heat_solver_impl.h>
#include <CGAL/Intrinsic_triangulations/applications/distance/Signed_heat_solver_impl.h>
#include <CGAL/Intrinsic_triangulations/applications/editing/Surface_deformation_impl.h>
#include <CGAL/Intrinsic_triangulations/applications/parametrization/certify_map_impl.h>
#include <CGAL/Intrinsic_triangulations/applications/parametrization/conformal_map_impl.h>
#include <CGAL/Intrinsic_triangulations/applications/parametrization/disk_border_impl.h>
#include <CGAL/Intrinsic_triangulations/applications/parametrization/point_cloud_map_impl.h>
