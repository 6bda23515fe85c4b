// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_COMPILED_H
#define CGAL_INTRINSIC_GEODESICS_COMPILED_H

/*!
\file
Declares the templates of curves and distances that the library has instantiated for the usual
triangulations, as `CGAL/Intrinsic_triangulations/compiled.h` does for triangulations.
`CGAL/Intrinsic_geodesics.h` includes this file.
*/

#include <CGAL/Intrinsic_geodesics/bezier/make_bezier_curve.h>
#include <CGAL/Intrinsic_geodesics/curves/insert_point.h>
#include <CGAL/Intrinsic_geodesics/curves/insert_polyline.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_along.h>
#include <CGAL/Intrinsic_geodesics/cuts/flip_to_geodesic_cut.h>
#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_geodesics/finding/Repeated_curve_finder.h>
#include <CGAL/Intrinsic_geodesics/finding/find_curves.h>
#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>
#include <CGAL/Intrinsic_geodesics/queries/add_geodesics.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_shortest_path.h>
#include <CGAL/Intrinsic_geodesics/shortening/certify_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_geodesics/single_source/flip_to_geodesic_tree.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/compiled.h>

#include <functional>
#include <vector>

/// \cond
// instantiates functions on curves of a triangulation, and the table that distances are found in.
#define CGAL_INTRINSIC_GEODESICS_FUNCTIONS(prefix, ...)                                            \
  prefix Added_geodesics<__VA_ARGS__> internal::find_and_add(                                      \
      Curve_network<__VA_ARGS__>&, const std::vector<Curve_through_vertices<__VA_ARGS__>>&,        \
      Flip_log<__VA_ARGS__>*, internal::Any_shortening_visitor&);                                  \
  prefix Curves_along_edges<__VA_ARGS__> internal::find_curves_with(                               \
      internal::Curve_tools<__VA_ARGS__>&, const std::vector<Wanted_curve>&,                       \
      const Find_curves_options&, const Edge_marker<__VA_ARGS__>&);                                \
  prefix Bezier_curve<__VA_ARGS__> make_bezier_curve(                                              \
      __VA_ARGS__&, const std::vector<Gluing_map::Vertex>&, const parameters::Parameters<>&);      \
  prefix Geodesic_tree<__VA_ARGS__> flip_to_geodesic_tree(__VA_ARGS__&, Gluing_map::Vertex,        \
                                                          const parameters::Parameters<>&);        \
  prefix Geodesic_cut<__VA_ARGS__> flip_to_geodesic_cut(__VA_ARGS__&);                             \
  prefix Shortening_result internal::shorten(                                                      \
      Curve_network<__VA_ARGS__>&, Flip_log<__VA_ARGS__>*, const internal::Shortening_limits&,     \
      const std::function<bool(const Shortening_result&)>&);                                       \
  prefix Geodesic_report is_geodesic(const Curve_network<__VA_ARGS__>&);                           \
  prefix Geodesic_report certify_geodesic(const Curve_network<__VA_ARGS__>&);                      \
  prefix std::vector<Vertex_at_point<__VA_ARGS__>> insert_point_on_sheets(__VA_ARGS__&,            \
                                                                          const Surface_point&);   \
  prefix Inserted_polyline<__VA_ARGS__> insert_polyline(__VA_ARGS__&,                              \
                                                        const std::vector<Surface_point>&);        \
  prefix Marked_edges<__VA_ARGS__, std::uint32_t> insert_curves(__VA_ARGS__&,                      \
                                                                const std::vector<Traced_curve>&); \
  prefix Marked_edges<__VA_ARGS__, std::uint32_t> insert_isolines(__VA_ARGS__&,                    \
                                                                  const std::vector<Isoline>&);    \
  prefix Traced_curve trace_isoline(const __VA_ARGS__&, const Isoline&);                           \
  prefix Traced_curve trace_curve(const __VA_ARGS__&, const std::vector<Gluing_map::Halfedge>&);   \
  prefix Traced_curve trace_shortest_path(const __VA_ARGS__&, const Shortest_path&);               \
  prefix internal::Corner_table internal::corner_table(const __VA_ARGS__&)
// instantiates them for the usual triangulations with a correspondence.
#define CGAL_INTRINSIC_GEODESICS_INSTANCES(prefix)                                                 \
  CGAL_INTRINSIC_TRIANGULATIONS_FOR_INTEGERS(CGAL_INTRINSIC_GEODESICS_FUNCTIONS, prefix)

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_GEODESICS_INSTANCES(extern template);

} // namespace CGAL::Intrinsic_triangulations
#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
/// \endcond

#endif // CGAL_INTRINSIC_GEODESICS_COMPILED_H
