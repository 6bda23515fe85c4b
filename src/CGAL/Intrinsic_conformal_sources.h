// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_SOURCES_H
#define CGAL_INTRINSIC_CONFORMAL_SOURCES_H

/*!
\file
All sources of the package `Intrinsic_conformal` and of those below it, for programs that do not link the library: exactly one of
their sources includes this file.
*/

#include <CGAL/Intrinsic_conformal/angles/Angle_system.cpp>
#include <CGAL/Intrinsic_conformal/angles/Ideal_surface.cpp>
#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.cpp>
#include <CGAL/Intrinsic_conformal/angles/flat_angles.cpp>
#include <CGAL/Intrinsic_conformal/angles/triangle_angles.cpp>
#include <CGAL/Intrinsic_conformal/layout/Disk_pieces.cpp>
#include <CGAL/Intrinsic_conformal/layout/Glued_pieces.cpp>
#include <CGAL/Intrinsic_conformal/layout/Piece_places.cpp>
#include <CGAL/Intrinsic_conformal/layout/Plane_pieces.cpp>
#include <CGAL/Intrinsic_conformal/layout/Sphere_centring.cpp>
#include <CGAL/Intrinsic_conformal/layout/conformal_sphere.cpp>
#include <CGAL/Intrinsic_conformal/layout/flat_torus.cpp>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_disk.cpp>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_plane.cpp>
#include <CGAL/Intrinsic_conformal/layout/lay_out_on_sphere.cpp>
#include <CGAL/Intrinsic_conformal/layout/lay_out_scaled.cpp>
#include <CGAL/Intrinsic_conformal/layout/lay_out_subdivision.cpp>
#include <CGAL/Intrinsic_conformal/layout/turn_back.cpp>
#include <CGAL/Intrinsic_conformal/maps/uniformize.cpp>
#include <CGAL/Intrinsic_conformal/metric/angle_enclosures.cpp>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.cpp>
#include <CGAL/Intrinsic_operators_sources.h>

#endif // CGAL_INTRINSIC_CONFORMAL_SOURCES_H
