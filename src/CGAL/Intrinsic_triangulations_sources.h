// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SOURCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SOURCES_H

/*!
\file
All sources of the package `Intrinsic_triangulations`, for programs that do not link the library:
exactly one of their sources includes this file.
*/

#include <CGAL/Intrinsic_triangulations/IO/curves/read_polylines.cpp>
#include <CGAL/Intrinsic_triangulations/IO/curves/scan_polylines_OBJ.cpp>
#include <CGAL/Intrinsic_triangulations/IO/curves/scan_polylines_PLY.cpp>
#include <CGAL/Intrinsic_triangulations/IO/curves/scan_polylines_VTP.cpp>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.cpp>
#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.cpp>
#include <CGAL/Intrinsic_triangulations/IO/idt/stored_surface.cpp>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.cpp>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.cpp>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.cpp>
#include <CGAL/Intrinsic_triangulations/IO/soup/scan_GOCAD.cpp>
#include <CGAL/Intrinsic_triangulations/IO/soup/scan_OBJ.cpp>
#include <CGAL/Intrinsic_triangulations/IO/soup/scan_OFF.cpp>
#include <CGAL/Intrinsic_triangulations/IO/soup/scan_PLY.cpp>
#include <CGAL/Intrinsic_triangulations/IO/soup/scan_STL.cpp>
#include <CGAL/Intrinsic_triangulations/IO/soup/scan_XYZ.cpp>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_output.cpp>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/subdivision_polygons.cpp>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/subdivision_tables.cpp>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.cpp>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.cpp>
#include <CGAL/Intrinsic_triangulations/IO/view/Html_view.cpp>
#include <CGAL/Intrinsic_triangulations/IO/view/write_html_view.cpp>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.cpp>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.cpp>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.cpp>
#include <CGAL/Intrinsic_triangulations/connectivity/count_elements.cpp>
#include <CGAL/Intrinsic_triangulations/connectivity/signed_incidence.cpp>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_development.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Insertion_placer.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Kept_crossings.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Triangle_strips.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Turn_products.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Turned_positions.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Unfolded_face.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/ideal_crossings.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signpost_queries.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Tangents_at_places.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_sectors.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Crossed_pieces.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Merged_edges.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Piece_gluer.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/expect_middle.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/overlay_subdivisions.cpp>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.cpp>
#include <CGAL/Intrinsic_triangulations/deciding/Exact_memory.cpp>
#include <CGAL/Intrinsic_triangulations/deciding/Followed_values.cpp>
#include <CGAL/Intrinsic_triangulations/domains/Delaunay_star.cpp>
#include <CGAL/Intrinsic_triangulations/domains/Domain.cpp>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.cpp>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.cpp>
#include <CGAL/Intrinsic_triangulations/domains/triangulate_polygons.cpp>
#include <CGAL/Intrinsic_triangulations/domains/tufted_cover.cpp>
#include <CGAL/Intrinsic_triangulations/exact/Exact_ladder.cpp>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.cpp>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.cpp>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Residues.cpp>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.cpp>
#include <CGAL/Intrinsic_triangulations/exact/proofs/field.cpp>
#include <CGAL/Intrinsic_triangulations/exact/proofs/flat.cpp>
#include <CGAL/Intrinsic_triangulations/exact/proofs/mirrored.cpp>
#include <CGAL/Intrinsic_triangulations/exact/proofs/prism.cpp>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.cpp>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.cpp>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.cpp>
#include <CGAL/Intrinsic_triangulations/formulas/Expression_steps.cpp>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.cpp>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.cpp>
#include <CGAL/Intrinsic_triangulations/formulas/apex.cpp>
#include <CGAL/Intrinsic_triangulations/input/Element_names.cpp>
#include <CGAL/Intrinsic_triangulations/input/Input.cpp>
#include <CGAL/Intrinsic_triangulations/input/Input_edges.cpp>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.cpp>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.cpp>
#include <CGAL/Intrinsic_triangulations/input/Polygon_shaper.cpp>
#include <CGAL/Intrinsic_triangulations/input/definition_of.cpp>
#include <CGAL/Intrinsic_triangulations/input/initial_values.cpp>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/Scaled_metric.cpp>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.cpp>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/triangle_inequality.cpp>
#include <CGAL/Intrinsic_triangulations/input/mollification.cpp>
#include <CGAL/Intrinsic_triangulations/input/polygons/Polygon_flattener.cpp>
#include <CGAL/Intrinsic_triangulations/input/polygons/Polygon_triangulator.cpp>
#include <CGAL/Intrinsic_triangulations/input/position_on_face.cpp>
#include <CGAL/Intrinsic_triangulations/input/renumbering.cpp>
#include <CGAL/Intrinsic_triangulations/input/scaling.cpp>
#include <CGAL/Intrinsic_triangulations/input/triangulate_face_graph.cpp>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.cpp>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.cpp>
#include <CGAL/Intrinsic_triangulations/metric/nearest_lengths.cpp>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure.cpp>
#include <CGAL/Intrinsic_triangulations/retriangulation/extrinsic/extrinsic_delaunay.cpp>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/Planar_star.cpp>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Constrained_segments.cpp>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_test.cpp>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.cpp>
#include <CGAL/Intrinsic_triangulations/support/Report.cpp>
#include <CGAL/Intrinsic_triangulations/tracing/walks_over_input.cpp>

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SOURCES_H
