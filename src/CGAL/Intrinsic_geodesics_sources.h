// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_SOURCES_H
#define CGAL_INTRINSIC_GEODESICS_SOURCES_H

/*!
\file
All sources of the package `Intrinsic_geodesics` and of those below it, for programs that do not
link the library: exactly one of their sources includes this file.
*/

#include <CGAL/Intrinsic_geodesics/curves/Curve_order.cpp>
#include <CGAL/Intrinsic_geodesics/cuts/Edge_graph.cpp>
#include <CGAL/Intrinsic_geodesics/cuts/cut_along.cpp>
#include <CGAL/Intrinsic_geodesics/cuts/cut_input.cpp>
#include <CGAL/Intrinsic_geodesics/cuts/cut_open.cpp>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.cpp>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_round_disk.cpp>
#include <CGAL/Intrinsic_geodesics/cuts/write_cut_surface.cpp>
#include <CGAL/Intrinsic_geodesics/distance/Corner_table.cpp>
#include <CGAL/Intrinsic_geodesics/distance/Distance_field.cpp>
#include <CGAL/Intrinsic_geodesics/distance/Face_complex.cpp>
#include <CGAL/Intrinsic_geodesics/distance/batches.cpp>
#include <CGAL/Intrinsic_geodesics/distance/spread_windows.cpp>
#include <CGAL/Intrinsic_geodesics/distance/trace_back.cpp>
#include <CGAL/Intrinsic_geodesics/isolines/Lines_on_surface.cpp>
#include <CGAL/Intrinsic_geodesics/isolines/isolines.cpp>
#include <CGAL/Intrinsic_geodesics/queries/Curve_inserter.cpp>
#include <CGAL/Intrinsic_geodesics/queries/certify_on_faces.cpp>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.cpp>
#include <CGAL/Intrinsic_geodesics/queries/trace_shortest_path.cpp>
#include <CGAL/Intrinsic_geodesics/voronoi/Face_divider.cpp>
#include <CGAL/Intrinsic_geodesics/voronoi/Weighted_site.cpp>
#include <CGAL/Intrinsic_geodesics/voronoi/cell_boundaries.cpp>
#include <CGAL/Intrinsic_triangulations_sources.h>

#endif // CGAL_INTRINSIC_GEODESICS_SOURCES_H
