// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_H
#define CGAL_INTRINSIC_GEODESICS_H

/*!
\file
Includes geodesic curves, paths, loops, networks and trees, Bezier curves, exact distances, shortest
paths, isolines and cuts; and `CGAL/Intrinsic_triangulations.h`.
*/

#include <CGAL/Intrinsic_geodesics/bezier/bezier_point.h>
#include <CGAL/Intrinsic_geodesics/bezier/make_bezier_curve.h>
#include <CGAL/Intrinsic_geodesics/compiled.h>
#include <CGAL/Intrinsic_geodesics/curves/add_marked_edges.h>
#include <CGAL/Intrinsic_geodesics/curves/insert_polyline.h>
#include <CGAL/Intrinsic_geodesics/cuts/Cut_surface.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_along.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_input.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_round_disk.h>
#include <CGAL/Intrinsic_geodesics/cuts/flip_to_geodesic_cut.h>
#include <CGAL/Intrinsic_geodesics/cuts/write_cut_surface.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/distance/batches.h>
#include <CGAL/Intrinsic_geodesics/distance/farthest_points.h>
#include <CGAL/Intrinsic_geodesics/finding/Repeated_curve_finder.h>
#include <CGAL/Intrinsic_geodesics/finding/find_curves.h>
#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>
#include <CGAL/Intrinsic_geodesics/queries/Geodesic_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/Paths_on_faces.h>
#include <CGAL/Intrinsic_geodesics/queries/add_geodesics.h>
#include <CGAL/Intrinsic_geodesics/queries/certify_on_faces.h>
#include <CGAL/Intrinsic_geodesics/queries/insert_places.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_shortest_path.h>
#include <CGAL/Intrinsic_geodesics/shortening/certify_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_geodesics/single_source/flip_to_geodesic_tree.h>
#include <CGAL/Intrinsic_geodesics/voronoi/voronoi_cells.h>
#include <CGAL/Intrinsic_triangulations.h>

#endif // CGAL_INTRINSIC_GEODESICS_H
