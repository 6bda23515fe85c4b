// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_MAKE_BEZIER_CURVE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_MAKE_BEZIER_CURVE_H

#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/geodesics/bezier/Bezier_curve.h>
#include <CGAL/Intrinsic_triangulations/geodesics/bezier/Bezier_subdivider.h>
#include <CGAL/Intrinsic_triangulations/geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_triangulations/triangulation/RefinableTriangulation.h>

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief makes a geodesic Bezier curve (§5.3 of the course) of any degree among the edges of an intrinsic triangulation.

The sides of the control polygon are shortest paths along edges, made geodesic. Each round subdivides it: of d + 1 control
points de Casteljau's algorithm at 1/2, with midpoints of geodesics, makes twice as many, which share the point in the middle. The
polygon converges to the curve. Every geodesic is the one that halves of two others are shortened to, never a shortest
path that is sought anew: those jump from one side of a bump to the other as the parameter grows, and the curve with them.

Midpoints are inserted as vertices, where half of the length is as a double; with exact traits they are rounded as in
`Intrinsic_triangulation::insert_vertex()`. Between them the sides are geodesics that `is_geodesic()` and
`certify_geodesic()` decide on exactly, once the control points are fixed in a network.

\tparam Triangulation a model of `GeodesicTriangulation` and of `RefinableTriangulation`
\tparam NP a chain of named parameters
\param t the triangulation; vertices are inserted, and edges flipped
\param control_points vertices, two at least
\param np optional named parameters:
  - `maximum_rounds(n)`: number of rounds. Default: 5.
  - `tolerance(x)`: stops when a round makes the control polygon shorter by at most this, in the units of the input. Default: 0.
\return the curve
\throws Invalid_input if sides of the control polygon cross
\throws std::invalid_argument if there are less than two control points
\complexity that of `shorten_curves()`, d times per round; and in the last round quadratic in the number of edges of the curve
*/
template <GeodesicTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
  requires RefinableTriangulation<Triangulation> Bezier_curve<Triangulation>
  make_bezier_curve(Triangulation& t,
                    const std::vector<typename Triangulation::vertex_descriptor>& control_points,
                    const NP& np = parameters::default_values()) {
    namespace tags = internal::tags;
    internal::expect_names<tags::maximum_rounds, tags::tolerance>(np);
    if (control_points.size() < 2)
      throw std::invalid_argument("a Bezier curve needs two control points at least");
    const unsigned rounds = internal::value_or<tags::maximum_rounds>(np, 5U);
    const double tolerance = internal::value_or<tags::tolerance>(np, 0.);
    const auto all = parameters::default_values();
    Bezier_curve<Triangulation> curve;
    curve.degree = control_points.size() - 1;
    internal::Bezier_subdivider<Triangulation> subdivider(t);
    Edge_path_finder<Triangulation> find_path(t);
    for (std::size_t i = 0; i < curve.degree; ++i) {
      auto way = find_path(control_points[i], control_points[i + 1]);
      if (way.empty() && control_points[i] != control_points[i + 1]) {
        curve.status = Status::stalled;
        return curve;
      }
      subdivider.add_side(control_points[i], control_points[i + 1], std::move(way));
    }
    curve.status = subdivider.shorten(all, curve.shortening);
    if (curve.status == Status::done) subdivider.describe(curve);
    while (curve.status == Status::done && curve.rounds < rounds) {
      const double before = curve.length;
      curve.status = subdivider.subdivide(curve.degree, all, curve);
      if (curve.status != Status::done) break;
      subdivider.describe(curve);
      ++curve.rounds;
      if (before - curve.length <= tolerance) break;
    }
    if (curve.status != Status::done) {
      curve.control_points.clear();
      curve.halfedges.clear();
    }
    return curve;
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_MAKE_BEZIER_CURVE_H
