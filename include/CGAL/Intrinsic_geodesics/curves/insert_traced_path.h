// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_INSERT_TRACED_PATH_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_INSERT_TRACED_PATH_H

#include <CGAL/Intrinsic_geodesics/curves/Line_inserter.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Move_status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/RefinableTriangulation.h>

#include <cmath>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a path of edges that vertices were inserted for.
\tparam Triangulation the type of the triangulation
*/
template <class Triangulation>
struct Inserted_path {
  /// `done`, or why a vertex could not be inserted; `border`: a line leads beyond it; `not_traceable`: a line has not met its end,
  /// by rounding.
  Move_status status = Move_status::done;
  /// The halfedges, in order; if the status is not `done`, as far as the path goes.
  std::vector<typename Triangulation::halfedge_descriptor> halfedges;
};

/*!
\brief makes a traced geodesic a path of edges of the triangulation.

Vertices are inserted at its start and its end, unless there are some, and on every edge that it crosses; where it crosses itself,
on its own edges. The geodesic is traced again, from vertex to vertex, so that it may cross an edge any number of times. Where it meets a
vertex up to rounding, it goes through it. Halfedges of earlier paths that it crosses become shorter or others: `Curve_network` is told of paths after all are
inserted.
\tparam Triangulation a model of `RefinableTriangulation`
\param t the triangulation
\param geodesic what `trace_geodesic()` returned, for `t` as it is now
\return the path. Each new vertex is where the triangulation rounds it, so that a path in exact arithmetic is a little bent. If it is refused somewhere,
vertices that were inserted before stay
\complexity linear in the number of crossings, and that of the insertions
*/
template <RefinableTriangulation Triangulation>
Inserted_path<Triangulation> insert_traced_path(Triangulation& t, const Geodesic& geodesic) {
  internal::Line_inserter<Triangulation> inserter(t);
  Corner_direction d{};
  Move_status status = inserter.start(geodesic.points.front(), geodesic.start_direction, d);
  if (status == Move_status::done)
    status = inserter.go(d, std::ldexp(geodesic.length, t.metric().scale_exponent()));
  return {status, inserter.paths().halfedges(t)};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_INSERT_TRACED_PATH_H
