# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Doxygen's input filter for headers: puts what a header documents into the group of its topic.
#
#     awk -f group_header.awk HEADER > what doxygen reads
#
# C++20 concepts that have a page in Intrinsic_triangulations/Concepts, as their comments say, are left out: one page is
# enough. Rooms are topics, with few exceptions, so that a new header is listed without anybody thinking of it. Lines keep their
# numbers. The groups themselves are in Intrinsic_triangulations/groups.h.

# The group of a header is that of the longest of these that its path starts with. The others, the owners of a
# triangulation, which lie beside the folder, are in `ref_owner`.
BEGIN {
  group["IO/"]                                               = "ref_io"
  group["IO/support/"]                                       = "ref_inside"
  group["IO/idt/Connectivity_reader.h"]                      = "ref_inside"
  group["IO/idt/Coordinates_reader.h"]                       = "ref_inside"
  group["IO/idt/Input_reader.h"]                             = "ref_inside"
  group["domains/"]                                          = "ref_input"
  group["domains/Delaunay_star.h"]                           = "ref_inside"
  group["domains/tufted_cover.h"]                            = "ref_inside"
  group["domains/triangulate_polygons.h"]                    = "ref_inside"
  group["IO/view/drawn_geometry.h"]                          = "ref_inside"
  group["IO/soup/scan_"]                                     = "ref_inside"
  group["connectivity/"]                                     = "ref_connectivity"
  group["connectivity/Invalid_input.h"]                      = "ref_owner"
  group["connectivity/Status.h"]                             = "ref_owner"
  group["connectivity/moves.h"]                              = "ref_inside"
  group["connectivity/parameters.h"]                         = "ref_owner"
  group["correspondence/"]                                   = "ref_correspondence"
  group["correspondence/Intrinsic_view.h"]                   = "ref_inside_correspondence"
  group["correspondence/Sheets.h"]                           = "ref_inside_correspondence"
  group["correspondence/curves/"]                            = "ref_inside_correspondence"
  group["correspondence/models/"]                            = "ref_inside_correspondence"
  group["correspondence/models/Explicit_crossings.h"]        = "ref_correspondence"
  group["correspondence/models/Integer_coordinates.h"]       = "ref_correspondence"
  group["correspondence/models/No_correspondence.h"]         = "ref_correspondence"
  group["correspondence/models/Signposts.h"]                 = "ref_correspondence"
  group["correspondence/queries/common_subdivision.h"]       = "ref_subdivision"
  group["correspondence/queries/Vertex_frames.h"]            = "ref_tracing"
  group["correspondence/queries/Vertex_sectors.h"]           = "ref_tracing"
  group["correspondence/queries/tangent.h"]                  = "ref_tracing"
  group["correspondence/queries/tangent_field.h"]            = "ref_tracing"
  group["correspondence/queries/trace_geodesic.h"]           = "ref_tracing"
  group["correspondence/queries/vector_field.h"]             = "ref_tracing"
  group["correspondence/subdivision/"]                       = "ref_subdivision"
  group["exact/"]                                            = "ref_exact"
  group["exact/Predicate_statistics.h"]                      = "ref_arithmetic"
  group["exact/numbers/"]                                    = "ref_numbers"
  group["exact/unfolding/"]                                  = "ref_unfolding"
  group["formulas/"]                                         = "ref_formulas"
  group["formulas/Expression_steps.h"]                       = "ref_exact"
  group["formulas/Recorded_expression.h"]                    = "ref_exact"
  group["formulas/nonnegative_intervals.h"]                  = "ref_exact"
  group["input/"]                                            = "ref_input"
  group["input/Input_metric.h"]                              = "ref_inside"
  group["input/Polygon_shaper.h"]                            = "ref_inside"
  group["input/initial_values.h"]                            = "ref_inside"
  group["input/metric_scaling/"]                             = "ref_metrics"
  group["input/position_on_face.h"]                          = "ref_inside"
  group["input/renumbering.h"]                               = "ref_inside"
  group["input/scaling.h"]                                   = "ref_inside"
  group["input/triangulate_face_graph.h"]                    = "ref_inside"
  group["metric/"]                                           = "ref_arithmetic"
  group["metric/Enclosed_values.h"]                          = "ref_exact"
  group["Intrinsic_operators/"]                              = "ref_operators"
  group["Intrinsic_operators/operators/symmetric_assembly.h"] = "ref_inside"
  group["Intrinsic_operators/operators/Connection_graph.h"]  = "ref_inside"
  group["Intrinsic_operators/distance/"]                     = "ref_applications"
  group["Intrinsic_operators/editing/"]                      = "ref_applications"
  group["Intrinsic_operators/maps/"]                         = "ref_applications"
  group["Intrinsic_operators/parametrization/"]              = "ref_applications"
  group["Intrinsic_operators/vectors/"]                      = "ref_applications"
  group["Intrinsic_operators/vectors/Direction_problem.h"]   = "ref_inside"
  group["Intrinsic_operators/vectors/Heat_transport.h"]      = "ref_inside"
  group["Intrinsic_operators/vectors/Point_frames.h"]        = "ref_inside"
  group["retriangulation/covers/"]                          = "ref_inside"
  group["retriangulation/covers/restore_input_edges.h"] = "ref_delaunay"
  group["retriangulation/delaunay/"]                         = "ref_delaunay"
  group["retriangulation/delaunay/Delaunay_flipper.h"]       = "ref_inside"
  group["retriangulation/optimization/"]                     = "ref_refinement"
  group["retriangulation/optimization/Odt_optimizer.h"]      = "ref_inside"
  group["retriangulation/optimization/Planar_star.h"]        = "ref_inside"
  group["retriangulation/refinement/"]                       = "ref_refinement"
  group["retriangulation/refinement/Constrained_segments.h"] = "ref_inside"
  group["retriangulation/refinement/Delaunay_refiner.h"]     = "ref_inside"
  group["retriangulation/refinement/Refinement_moves.h"]    = "ref_inside"
  group["retriangulation/refinement/Refinement_test.h"]      = "ref_inside"
  group["retriangulation/refinement/dijkstra_ball.h"]        = "ref_inside"
  group["retriangulation/refinement/locate_circumcenter.h"]  = "ref_inside"
  group["Intrinsic_geodesics/"]                              = "ref_curves"
  group["tracing/"]                                          = "ref_inside_tracing"
  group["tracing/trace_geodesic.h"]                          = "ref_tracing"
  group["triangulation/"]                                    = "ref_inside"
  group["triangulation/Session.h"]                           = "ref_owner"
  group["triangulation/Surface_point.h"]                     = "ref_owner"
  group["triangulation/measures.h"]                          = "ref_measures"
}

function group_of(path,    prefix, best) {
  sub(/.*include\/CGAL\/(Intrinsic_triangulations\/)?/, "", path)
  best = ""
  for (prefix in group)
    if (index(path, prefix) == 1 && length(prefix) > length(best)) best = prefix
  return best == "" ? "ref_owner" : group[best]
}

# The number of the line in which the declaration ends that begins at a line.
function end_of_declaration(n,    depth) {
  for (depth = 0; n < NR; ++n) {
    depth += gsub(/{/, "{", line[n]) - gsub(/}/, "}", line[n])
    if (depth == 0 && line[n] ~ /;$/) break
  }
  return n
}

{ line[FNR] = $0 }
/^\/\*!$/ { comment = FNR }
/^Syntax of \\ref ::/ { first[++concepts] = comment }
/^concept / { if (concepts > closed) last[++closed] = FNR }

END {
  for (i = 1; i <= concepts; ++i) {
    line[first[i]] = "/*! \\cond */ " line[first[i]]
    n = end_of_declaration(last[i])
    line[n] = line[n] " /*! \\endcond */"
  }
  for (i = 1; i <= NR; ++i) {
    if (line[i] == "namespace CGAL::Intrinsic_triangulations {")
      line[i] = line[i] " /*! \\addtogroup " group_of(FILENAME) " */ /*! @{ */"
    if (line[i] == "} // namespace CGAL::Intrinsic_triangulations")
      line[i] = "/*! @} */ " line[i]
    print line[i]
  }
}
