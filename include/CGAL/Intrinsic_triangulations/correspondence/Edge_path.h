// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_EDGE_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_EDGE_PATH_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstdint>
#include <vector>

/*!
\file
Points and edges of one triangulation, and where they are on the other.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a point of the other triangulation, and how vectors are taken there: a direction in two
frames.
*/
struct Mapped_point {
  /// The point.
  Surface_point point;
  /// The direction in the frame of the halfedge that the point was given with.
  Plane_vector<double> given{1, 0};
  /// The direction in the frame of `point.halfedge`.
  Plane_vector<double> found{1, 0};

  /// takes a tangent vector from the frame where the point was given to that of `point.halfedge`.
  template <class Units>
  Plane_vector<double, Units> transfer(const Plane_vector<double, Units>& v) const {
    using Vector = Plane_vector<double, Units>;
    return Vector{found.x, found.y} * in_frame(Vector{given.x, given.y}, v);
  }
};

/// A point of an edge that is traced over the other triangulation.
struct Path_point {
  Surface_point on_input;     ///< where it is on the input
  Surface_point on_intrinsic; ///< where it is on the intrinsic triangulation
  double parameter;           ///< 0 at the start of the edge, 1 at its end
};

/*!
\brief is the path of an edge of one triangulation over the other.
*/
struct Edge_path {
  /// `done`; `inaccurate`, with `Signposts` only: some vertex is so close to the path that rounding
  /// may have decided its side, so that points may be missing or superfluous; or `not_traceable`,
  /// without points.
  Status status = Status::done;
  /// The halfedge of the other triangulation that contains the whole edge, in its direction;
  /// `Gluing::none` if there is none.
  std::uint32_t along = Gluing::none;
  /// Its start, the points where it crosses or meets edges and vertices of the other triangulation,
  /// and its end: at least two points. Between them it is straight and in one face of both. A
  /// crossing of an intrinsic edge with an input edge is named in the input face that the intrinsic
  /// edge enters.
  std::vector<Path_point> points;
};

namespace internal {

/// returns a point of a halfedge, or of its opposite if it has no face: 0 is at the source of `h`.
template <class Complex>
Surface_point point_on_halfedge(const Complex& complex, std::uint32_t h, double x) {
  if (complex.is_border(h)) return {h ^ 1U, {x, 1 - x, 0}};
  return {h, {1 - x, x, 0}};
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_EDGE_PATH_H
