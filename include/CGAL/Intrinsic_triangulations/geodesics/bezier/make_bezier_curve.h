// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_MAKE_BEZIER_CURVE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_MAKE_BEZIER_CURVE_H

#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/geodesics/bezier/Bezier_curve.h>
#include <CGAL/Intrinsic_triangulations/geodesics/bezier/Bezier_subdivider.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/RefinableTriangulation.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief makes a geodesic Bezier curve (§5.3 of the course) of any degree among the edges of an intrinsic triangulation.

The sides of the control polygon are shortest paths. Each round subdivides it: of d + 1 control
points de Casteljau's algorithm at 1/2, with midpoints of geodesics, makes twice as many, which share the point in the middle. The
polygon converges to the curve. Every other geodesic is the one that halves of two others are
shortened to, not a shortest path that is sought anew: those jump from one side of a bump to the
other as the parameter grows, and the curve with them. Only where two halves cross, a shortest path
takes their place.

Each geodesic is found alone on the surface: no other line is in its way. So in a convex part of a
plane all control points lie where they do in a plane. In the end the sides of the last polygon are
made edges. Where the polygon crosses itself, a vertex is inserted.

All edges are flipped to Delaunay before and between rounds. Midpoints are inserted as vertices,
where half of the length is as a double; with exact traits they are rounded as in
`Intrinsic_triangulation::insert_vertex()`. Between them the sides are geodesics that
`is_geodesic()` and `certify_geodesic()` decide on exactly, once the control points and
`Bezier_curve::crossings` are fixed in a network.

\tparam Triangulation a model of `GeodesicTriangulation`, of `RefinableTriangulation` and of
  `CorrespondingTriangulation`
\tparam NP a chain of named parameters
\param t the triangulation; vertices are inserted, and edges flipped
\param control_points vertices, two at least
\param np optional named parameters:
  - `maximum_rounds(n)`: number of rounds. Default: 5.
  - `tolerance(x)`: stops when a round makes the control polygon shorter by at most this, in the units of the input. Default: 0.
\return the curve
\throws std::invalid_argument if there are less than two control points
\complexity that of d shortest paths, of `flip_to_delaunay()` r + 1 times for r rounds, and d
  (d - 1) / 2 times 2^r - 1 that of `shorten_curves()`
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
    Bezier_curve<Triangulation> curve;
    curve.degree = control_points.size() - 1;
    internal::Bezier_subdivider<Triangulation> subdivider(t);
    curve.status = subdivider.start(control_points, curve.shortening);
    while (curve.status == Status::done && curve.rounds < rounds) {
      const double before = subdivider.length();
      curve.status = subdivider.subdivide(curve.degree, curve.shortening);
      if (curve.status != Status::done) break;
      ++curve.rounds;
      if (before - subdivider.length() <= tolerance) break;
    }
    if (curve.status == Status::done) curve.status = subdivider.finish(curve);
    if (curve.status != Status::done) {
      curve.control_points.clear();
      curve.halfedges.clear();
    }
    return curve;
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_MAKE_BEZIER_CURVE_H
