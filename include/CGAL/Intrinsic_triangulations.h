// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_H

/*!
\file
Includes what most programs need for triangulations. Include separately:
`CGAL/Intrinsic_geodesics.h` for curves and exact distances; `CGAL/Intrinsic_operators.h`, which
needs Eigen, for matrices, solvers and what they solve; the adaptors of OpenMesh and
`CGAL::Polyhedron_3` from `CGAL/Intrinsic_triangulations/connectivity/`; files of intrinsic
triangulations (`read_intrinsic_triangulation.h`, `write_intrinsic_triangulation.h`) and pages that
show them (`write_html_view.h`) from `CGAL/Intrinsic_triangulations/IO/`.
*/

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/build_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/count_elements.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Tangents_at_places.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/input/Input_edges.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Interval_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Tolerant_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/covers/restore_input_edges.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/certify_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/odt_optimize.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/support/Report.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#endif // CGAL_INTRINSIC_TRIANGULATIONS_H
