// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TRACE_GEODESIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TRACE_GEODESIC_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/tracing/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a geodesic over the faces of a triangulation.
*/
struct Geodesic {
  /// `done`; `border` if it reached the border before its length; `cap` if it reached the cap on
  /// faces.
  Status status = Status::done;
  /// The start, a point on each crossed edge (in the face before it), and the end.
  std::vector<Surface_point> points;
  /// Unit vector along it at its end, in the frame of the halfedge of the last point.
  Plane_vector<double> direction{1, 0};
  /// Its length, in the units of the input.
  double length = 0;
  /// First-order bound on the error of the end, in the units of the input.
  double error = 0;
};

namespace internal {

// over a model of `NumberedComplex`, for a length in the units of the input
template <class Complex, class Units, class NP>
Geodesic trace_on(const Complex& complex, const Surface_point& start,
                  const Plane_vector<double, Units>& direction, double length, const NP& np) {
  using namespace tags;
  expect_names<maximum_faces, snaps_to_vertices>(np);
  const Trace_options d;
  const Trace_options options{value_or<maximum_faces>(np, d.maximum_faces),
                              value_or<tags::snaps_to_vertices>(np, d.snaps_to_vertices)};
  std::vector<Geodesic_crossing> crossings;
  const Geodesic_end end = internal::trace_geodesic(
      complex, start, direction, std::ldexp(length, complex.scale_exponent()), crossings, options);
  Geodesic g{end.status,
             {start},
             end.direction,
             std::ldexp(end.length, -complex.scale_exponent()),
             std::ldexp(end.error, -complex.scale_exponent())};
  g.points.reserve(crossings.size() + 2);
  for (const Geodesic_crossing& c : crossings)
    g.points.push_back({c.halfedge, {1 - c.parameter, c.parameter, 0}});
  g.points.push_back(end.point);
  return g;
}

} // namespace internal

/*!
\brief traces a geodesic over the intrinsic triangulation (§2.4.2 of the course): the exponential
map.

It is straight inside faces and across edges, continues straightest at an interior vertex, and stops
at the border.
\tparam Triangulation a model of `NumberedTriangulation`
\tparam NP a chain of named parameters
\tparam Units any type, see `Plane_vector`
\param t the triangulation
\param start a point of it
\param direction in the frame of `start.halfedge`, which runs along the x-axis with its face above;
  norm and units do not matter. At a vertex, a direction that points out of the face is measured
  around the vertex from the nearer side.
\param length the length to go, in the units of the input
\param np optional named parameters: - `maximum_faces(n)`: number of faces after which to give up.
  Default: 2^22. - `snaps_to_vertices(b)`: whether a line that meets a vertex up to rounding goes
  through it; otherwise it passes on one side. Default: true.
\pre the direction is not zero
\complexity linear in the number of crossings, and in the degrees of the vertices that are hit
*/
template <NumberedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>,
          class Units = void>
Geodesic trace_geodesic(const Triangulation& t, const Surface_point& start,
                        const Plane_vector<double, Units>& direction, double length,
                        const NP& np = parameters::default_values()) {
  return internal::trace_on(Intrinsic_view<Triangulation>(t), start, direction, length, np);
}

/*!
\brief traces a geodesic over the input.

See `trace_geodesic()`; points are those of the input.
\tparam Triangulation a model of `CorrespondingTriangulation`
\tparam Units any type, see `Plane_vector`
*/
template <QueriedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>,
          class Units = void>
Geodesic trace_geodesic_on_input(const Triangulation& t, const Surface_point& start,
                                 const Plane_vector<double, Units>& direction, double length,
                                 const NP& np = parameters::default_values()) {
  return internal::trace_on(t.correspondence().input(), start, direction, length, np);
}

/*!
\brief traces a geodesic over the user's mesh.

See `trace_geodesic()`; points are those of the input, and `face_location(t, point, mesh)` is the
place of one.
\param t the triangulation
\param start a place on the mesh, in a triangle
\param direction in the frame of `halfedge(start.first, mesh)`
\param length the length to go, in the units of the mesh
\param mesh the mesh that `t` was built from
\param np as there
\throws Invalid_input if the start is in a polygon, or the mesh is another one
*/
template <QueriedTriangulation Triangulation, ReadableFaceGraph Mesh,
          NamedParameters NP = parameters::Parameters<>, class Units = void>
  requires(!NamedParameters<Mesh>)
Geodesic trace_geodesic(const Triangulation& t,
                        const Face_location<std::type_identity_t<Mesh>>& start,
                        const Plane_vector<double, Units>& direction, double length,
                        const Mesh& mesh, const NP& np = parameters::default_values()) {
  return trace_geodesic_on_input(t, surface_point(t, start, mesh), direction, length, np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TRACE_GEODESIC_H
