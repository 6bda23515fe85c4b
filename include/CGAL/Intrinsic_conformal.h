// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_H
#define CGAL_INTRINSIC_CONFORMAL_H

/*!
\file
Includes conformal metrics with prescribed angles, their layouts in the plane, on the sphere and in
Poincaré's disk, and `CGAL/Intrinsic_operators.h`. Needs Eigen.
*/

#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>
#include <CGAL/Intrinsic_conformal/angles/flat_angles.h>
#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>
#include <CGAL/Intrinsic_conformal/layout/conformal_sphere.h>
#include <CGAL/Intrinsic_conformal/layout/flat_torus.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_disk.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_plane.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_on_sphere.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_scaled.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_subdivision.h>
#include <CGAL/Intrinsic_conformal/maps/uniformize.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_conformal/metric/flat_surface.h>
#include <CGAL/Intrinsic_conformal/metric/hyperbolic_metric.h>
#include <CGAL/Intrinsic_operators.h>

#endif // CGAL_INTRINSIC_CONFORMAL_H
